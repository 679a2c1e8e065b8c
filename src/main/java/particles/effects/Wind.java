package particles.effects;

import java.util.Arrays;

/**
 * The velocity field of the air. It exerts no force of its own: air drag uses it to compute the velocity of a particle
 * relative to the air.
 */
public interface Wind {
    /** Air at rest. */
    Wind STILL = (state, time, wind, from, to) -> Arrays.fill(wind, 6 * from, 6 * to, 0.0);

    /**
     * Computes the velocity of the air at each particle.
     *
     * @param state the particles' state, read only; several threads may call this at once for different particles
     * @param time  t (s)
     * @param wind  receives the air's velocity at each particle (m/s), in the entries that hold the particle's velocity
     *              in the state
     * @param from  first particle
     * @param to    one past the last particle
     */
    void getVelocities(double[] state, double time, double[] wind, int from, int to);

    /** @return the period of the wind (s); infinite if it has none */
    default double getPeriod() {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * Computes the gradient of the air's velocity at a particle; by default 0, as in wind that is the same everywhere.
     *
     * @param state    the particles' state, to be read only
     * @param time     t (s)
     * @param i        the particle
     * @param gradient receives 9 doubles, row by row: entry 3 a + b is the derivative of component a with respect to
     *                 coordinate b (1/s)
     */
    default void getGradient(double[] state, double time, int i, double[] gradient) {
        Arrays.fill(gradient, 0);
    }
}
