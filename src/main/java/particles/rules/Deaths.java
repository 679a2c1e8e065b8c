package particles.rules;

import particles.ParticleSystem;

/** Takes the particles out of a system that a test picks. */
final class Deaths {
    private Deaths() {
    }

    /** Which particles go. */
    interface Test {
        boolean goes(ParticleSystem system, int i);
    }

    /** Returns whether any went; looks first, so that a step without a death allocates nothing. */
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
