package particles.lab;

import java.util.Map;

/**
 * A moment of a run.
 *
 * @param time      t (s)
 * @param state     positions and velocities, six numbers per particle (m, m/s)
 * @param energies  the energies in the order of {@link FrameRecorder#getEnergyNames()} (J)
 * @param structure the particles and springs at that time
 * @param account   what it cost to come there
 */
record Frame(double time, float[] state, float[] energies, Structure structure, Account account) {

    /**
     * What the run had cost by then.
     *
     * @param steps       the steps
     * @param evaluations the evaluations of the derivative
     * @param work        the work done on the system, by name (J)
     */
    record Account(long steps, long evaluations, Map<String, Double> work) {
    }

    /** About the number of bytes that it takes, without its structure, which it shares with others. */
    long bytes() {
        return 200 + 100L * account.work().size() + 4L * state.length + 4L * energies.length;
    }
}
