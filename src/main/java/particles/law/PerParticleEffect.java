package particles.law;

/**
 * An effect whose force on a particle depends on that particle alone, as gravity and drag do, so that several threads
 * can evaluate ranges of particles at once. {@link ParticleForce} is simpler to write, and runs on one thread.
 */
public interface PerParticleEffect extends Effect {

    /**
     * Adds the forces on the particles from ... to - 1. Several threads may call it at once for different ranges.
     *
     * @param state the particles' state (m, m/s); read only
     * @param time  t (s)
     * @param force add each force (N) to the entries that hold the particle's velocity in the state
     * @param from  first particle
     * @param to    one past the last particle
     */
    void addForces(double[] state, double time, double[] force, int from, int to);

    @Override
    default void addForces(double[] state, double time, double[] force) {
        addForces(state, time, force, 0, force.length / Particles.STRIDE);
    }
}
