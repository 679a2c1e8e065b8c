package particles.reactions;

import java.util.Arrays;
import particles.law.Particles;

/**
 * The contact mode of each particle at each surface: free, sliding or sticking. Rules change it between steps; it is
 * constant within a step.
 */
public final class ContactModes {

    /** The contact mode of a particle at a surface. */
    public enum Mode {
        /** It does not touch. */
        FREE,
        /** It touches and slides, or would if it moved. */
        SLIDING,
        /** It touches, and static friction holds it. */
        STICKING,
    }

    private final Particles particles;
    private final int surfaces;
    private final OfParticle free;                      // of all particles that never touched any surface
    private OfParticle[] known = {};                    // by particle
    private int touching;                               // the number of touched surfaces of all particles
    private int changes;

    /** Makes modes for a number of surfaces, all free. */
    public ContactModes(Particles particles, int surfaces) {
        this.particles = particles;
        this.surfaces = surfaces;
        free = new OfParticle(surfaces);
    }

    /** The modes of a particle, with the answers that rules and forces ask for in every step. */
    private static final class OfParticle {
        private final Mode[] modes;                     // by surface
        private Mode most = Mode.FREE;
        private int touched;                            // the number of surfaces that it touches
        private int last = -1;                          // the last of them

        OfParticle(int surfaces) {
            modes = new Mode[surfaces];
            Arrays.fill(modes, Mode.FREE);
        }

        void set(int surface, Mode mode) {
            modes[surface] = mode;
            most = Mode.FREE;
            touched = 0;
            for (int p = 0; p < modes.length; p++) {
                if (modes[p] != Mode.FREE) {
                    most = modes[p].compareTo(most) > 0 ? modes[p] : most;
                    touched++;
                    last = p;
                }
            }
        }
    }

    private OfParticle of(int particle) {
        return particle < known.length ? known[particle] : free;
    }

    /**
     * @param surface  index of a surface
     * @param particle index of a particle
     * @return the particle's mode at the surface
     */
    public Mode get(int surface, int particle) {
        return of(particle).modes[surface];
    }

    /**
     * @param surface  index of a surface
     * @param particle index of a particle
     * @param mode     its new mode
     */
    public void set(int surface, int particle, Mode mode) {
        Mode before = get(surface, particle);
        if (before == mode) {
            return;
        }
        changes++;
        int end = known.length;
        if (end < particles.count()) {
            known = Arrays.copyOf(known, particles.count());
            Arrays.fill(known, end, known.length, free);
        }
        if (known[particle] == free) {
            known[particle] = new OfParticle(surfaces);
        }
        known[particle].set(surface, mode);
        touching += (mode == Mode.FREE ? 0 : 1) - (before == Mode.FREE ? 0 : 1);
    }

    /**
     * Lets a particle slide or stick at all the surfaces that it touches.
     *
     * @param particle index of a particle
     * @param mode     sliding or sticking
     */
    public void setWhereTouching(int particle, Mode mode) {
        for (int p = 0; p < surfaces; p++) {
            if (get(p, particle) != Mode.FREE) {
                set(p, particle, mode);
            }
        }
    }

    /** The surface that a particle touches, if it is one only; -1 otherwise. */
    int only(int particle) {
        return of(particle).touched == 1 ? of(particle).last : -1;
    }

    /** Updates indices after particles were removed. */
    public void reindex(int[] newIndex) {
        OfParticle[] before = known;
        known = new OfParticle[particles.count()];
        Arrays.fill(known, free);
        touching = 0;
        changes++;
        for (int i = 0; i < Math.min(before.length, newIndex.length); i++) {
            if (newIndex[i] >= 0) {
                known[newIndex[i]] = before[i];
                touching += before[i].touched;
            }
        }
    }

    /** The number of changes so far. */
    public int getChanges() {
        return changes;
    }

    /** @return true if any particle touches any surface */
    public boolean isAnyTouching() {
        return touching > 0;
    }

    /** @return one more than the largest index of a particle that ever touched a surface, or more */
    public int end() {
        return known.length;
    }

    /**
     * @param particle index of a particle
     * @return true if it touches any surface
     */
    public boolean isTouching(int particle) {
        return of(particle).touched > 0;
    }

    /**
     * @param particle index of a particle
     * @return true if it touches a surface and static friction holds it there
     */
    public boolean isSticking(int particle) {
        return of(particle).most == Mode.STICKING;
    }
}
