package particles;

/** An effect that knows the derivatives of its forces, which implicit solvers use instead of differences. */
public interface DifferentiableEffect extends Effect {

    /** @return whether {@link #addForceDerivatives} adds all derivatives; if not, solvers use differences after all */
    default boolean hasForceDerivatives() {
        return true;
    }

    /**
     * Adds the derivatives of all forces by positions and velocities. By default there are none: the force on a
     * particle is always the same.
     *
     * @param state       the particles' state; read only
     * @param time        t (s)
     * @param derivatives receives them
     */
    default void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
    }
}
