package particles.rules;

import particles.ParticleSystem;

/** Removes the particles of a system for which a test is true. */
final class Deaths {
    private Deaths() {
    }

    /** Selects the particles to remove. */
    interface Test {
        boolean goes(ParticleSystem system, int i);
    }

    /** Returns whether any particle was removed. */
    static boolean remove(ParticleSystem system, Test test) {
        boolean[] gone = new boolean[system.getParticles().count()];
        boolean any = false;
        for (int i = 0; i < gone.length; i++) {
            gone[i] = test.goes(system, i);
            any |= gone[i];
        }
        if (any) {
            system.removeParticles(gone);
        }
        return any;
    }
}
