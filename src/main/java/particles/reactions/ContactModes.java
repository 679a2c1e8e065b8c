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
    // by particle, then surface; null for those that never touched any
    private Mode[][] modes = {};
    private int touching;
    private int changes;

    /** Makes modes for a number of surfaces, all free. */
    public ContactModes(Particles particles, int surfaces) {
        this.particles = particles;
        this.surfaces = surfaces;
    }

    /**
     * @param surface  index of a surface
     * @param particle index of a particle
     * @return the particle's mode at the surface
     */
    public Mode get(int surface, int particle) {
        return particle < modes.length && modes[particle] != null ? modes[particle][surface] : Mode.FREE;
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
        if (modes.length < particles.count()) {
            modes = Arrays.copyOf(modes, particles.count());
        }
        if (modes[particle] == null) {
            modes[particle] = new Mode[surfaces];
            Arrays.fill(modes[particle], Mode.FREE);
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
        for (int p = 0; p < surfaces; p++) {
            if (get(p, particle) != Mode.FREE) {
                set(p, particle, mode);
            }
        }
    }

    /** The surface that a particle touches, if it is one only; -1 otherwise. */
    int only(int particle) {
        int only = -1;
        for (int p = 0; p < surfaces; p++) {
            if (get(p, particle) != Mode.FREE) {
                if (only >= 0) {
                    return -1;
                }
                only = p;
            }
        }
        return only;
    }

    /** Updates indices after particles were removed. */
    public void reindex(int[] newIndex) {
        Mode[][] before = modes;
        modes = new Mode[particles.count()][];
        touching = 0;
        changes++;
        for (int i = 0; i < Math.min(before.length, newIndex.length); i++) {
            if (newIndex[i] >= 0 && before[i] != null) {
                modes[newIndex[i]] = before[i];
                for (Mode mode : before[i]) {
                    touching += mode == Mode.FREE ? 0 : 1;
                }
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

    /** The mode of a particle at any surface: it sticks if it sticks at one, and is free if it touches none. */
    private Mode get(int particle) {
        Mode most = Mode.FREE;
        for (int p = 0; p < surfaces; p++) {
            most = get(p, particle).compareTo(most) > 0 ? get(p, particle) : most;
        }
        return most;
    }

    /**
     * @param particle index of a particle
     * @return true if it touches any surface
     */
    public boolean isTouching(int particle) {
        return get(particle) != Mode.FREE;
    }

    /**
     * @param particle index of a particle
     * @return true if it touches a surface and static friction holds it there
     */
    public boolean isSticking(int particle) {
        return get(particle) == Mode.STICKING;
    }
}
