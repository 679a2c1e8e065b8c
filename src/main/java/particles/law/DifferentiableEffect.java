package particles.law;

import deSolvers.ForceDerivatives;

/** An effect that knows the derivatives of its forces, which implicit solvers use instead of finite differences. */
public interface DifferentiableEffect extends Effect {

    /**
     * Adds the derivatives of all forces with respect to positions and velocities. The default adds none, which is
     * right only for a force that is the same everywhere and at every velocity.
     *
     * @param state       the particles' state; read only
     * @param time        t (s)
     * @param derivatives receives them
     */
    default void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
    }
}
