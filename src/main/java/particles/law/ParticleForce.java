package particles.law;

/**
 * Base class of force laws that act on each particle separately, and the simplest way to write one: a subclass computes
 * the force on one particle from its position, velocity and mass and the time. It implements {@link #getForce} and, if
 * the force is conservative, also {@link #getPotentialEnergy(Vector3, double, double)}.
 */
public abstract class ParticleForce implements Effect {
    private final Particles particles;

    /** @param particles the particles that the force acts on */
    protected ParticleForce(Particles particles) {
        this.particles = particles;
    }

    /**
     * Computes the force on one particle.
     *
     * @param position x (m)
     * @param velocity v (m/s)
     * @param mass     m (kg)
     * @param time     t (s)
     * @return the force on the particle (N)
     */
    protected abstract Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time);

    /**
     * Computes the potential energy of one particle; a conservative force overrides it.
     *
     * @param position x (m)
     * @param mass     m (kg)
     * @param time     t (s)
     * @return the potential energy of one particle (J), 0 if there is none
     */
    protected double getPotentialEnergy(Vector3 position, double mass, double time) {
        return 0;
    }

    /** {@inheritDoc} By default it is the name of the class. */
    @Override
    public String getName() {
        return getClass().getSimpleName();
    }

    @Override
    public final void addForces(double[] state, double time, double[] force) {
        for (int i = 0, x = 0; i < particles.count(); i++, x += Particles.STRIDE) {
            Vector3 f = getForce(Vector3.at(state, x), Vector3.at(state, x + 3), particles.mass(i), time);
            force[x + 3] += f.x();
            force[x + 4] += f.y();
            force[x + 5] += f.z();
        }
    }

    /** {@inheritDoc} The sum over all particles that are not fixed. */
    @Override
    public final double getPotentialEnergy(double[] state, double time) {
        return particles.sumOfFree(i -> getPotentialEnergy(Vector3.at(state, Particles.STRIDE * i), particles.mass(i),
                time));
    }
}
