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

    /** Returns whether any particle was removed; a step without a death allocates nothing. */
    static boolean remove(ParticleSystem system, Test test) {
        int n = system.getParticles().count();
        int first = 0;
        while (first < n && !test.goes(system, first)) {
            first++;
        }
        if (first == n) {
            return false;
        }
        boolean[] gone = new boolean[n];
        for (int i = first; i < n; i++) {
            gone[i] = test.goes(system, i);
        }
        system.removeParticles(gone);
        return true;
    }
}
