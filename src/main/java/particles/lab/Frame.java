package particles.lab;

/**
 * A moment of a run.
 *
 * @param time      t (s)
 * @param state     positions and velocities, six numbers per particle (m, m/s)
 * @param energies  the energies in the order of {@link EnergyParts#getNames()} (J)
 * @param structure the particles and springs at that time
 */
record Frame(double time, float[] state, float[] energies, Structure structure) {

    /** About the number of bytes that it takes, without its structure, which it shares with others. */
    long bytes() {
        return 100 + 4L * state.length + 4L * energies.length;
    }
}
