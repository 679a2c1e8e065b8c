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
    private final Mode[] free;                          // of all particles that never touched any surface
    private Mode[][] modes = {};                        // by particle and surface
    private int touching;
    private int changes;

    /** Makes modes for a number of surfaces, all free. */
    public ContactModes(Particles particles, int surfaces) {
        this.particles = particles;
        free = new Mode[surfaces];
        Arrays.fill(free, Mode.FREE);
    }

    private Mode[] of(int particle) {
        return particle < modes.length ? modes[particle] : free;
    }

    /**
     * @param surface  index of a surface
     * @param particle index of a particle
     * @return the particle's mode at the surface
     */
    public Mode get(int surface, int particle) {
        return of(particle)[surface];
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
        int known = modes.length;
        if (known < particles.count()) {
            modes = Arrays.copyOf(modes, particles.count());
            Arrays.fill(modes, known, modes.length, free);
        }
        if (modes[particle] == free) {
            modes[particle] = free.clone();
        }
        modes[particle][surface] = mode;
        touching += (mode == Mode.FREE ? 0 : 1) - (before == Mode.FREE ? 0 : 1);
    }

    /**
     * Lets a particle slide or stick at all the surfaces that it touches.
     *
     * @param particle index of a particle
     * @param mode     sliding or sticking
     */
    public void setWhereTouching(int particle, Mode mode) {
        for (int p = 0; p < free.length; p++) {
            if (get(p, particle) != Mode.FREE) {
                set(p, particle, mode);
            }
        }
    }

    /** The surface that a particle touches, if it is one only; -1 otherwise. */
    int only(int particle) {
        int only = -1;
        int count = 0;
        for (int p = 0; p < free.length; p++) {
            if (of(particle)[p] != Mode.FREE) {
                only = p;
                count++;
            }
        }
        return count == 1 ? only : -1;
    }

    /** Updates indices after particles were removed. */
    public void reindex(int[] newIndex) {
        Mode[][] before = modes;
        modes = new Mode[particles.count()][];
        Arrays.fill(modes, free);
        touching = 0;
        changes++;
        for (int i = 0; i < Math.min(before.length, newIndex.length); i++) {
            if (newIndex[i] >= 0) {
                modes[newIndex[i]] = before[i];
                touching += (int) Arrays.stream(before[i]).filter(mode -> mode != Mode.FREE).count();
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
        return modes.length;
    }

    /**
     * @param particle index of a particle
     * @return true if it touches any surface
     */
    public boolean isTouching(int particle) {
        return has(particle, Mode.SLIDING) || has(particle, Mode.STICKING);
    }

    /**
     * @param particle index of a particle
     * @return true if it touches a surface and static friction holds it there
     */
    public boolean isSticking(int particle) {
        return has(particle, Mode.STICKING);
    }

    private boolean has(int particle, Mode mode) {
        for (Mode each : of(particle)) {
            if (each == mode) {
                return true;
            }
        }
        return false;
    }
}
