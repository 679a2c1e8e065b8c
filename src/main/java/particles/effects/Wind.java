package particles.effects;

import java.util.Arrays;

/**
 * A field of moving air. It exerts no force of its own: air drag asks it how fast the air moves past a particle.
 */
public interface Wind {
    /** Air at rest. */
    Wind STILL = (state, time, wind, from, to) -> Arrays.fill(wind, 6 * from, 6 * to, 0.0);

    /**
     * The velocity of the air where particles are.
     *
     * @param state the particles' state, to be read only; several threads may ask at once, for different particles
     * @param time  t (s)
     * @param wind  receives the air's velocity at each particle where its own stands in the state (m/s)
     * @param from  first particle
     * @param to    one past the last particle
     */
    void getVelocities(double[] state, double time, double[] wind, int from, int to);

    /** @return whether the air moves in the same way everywhere, whatever the particles do */
    default boolean isUniform() {
        return false;
    }

    /** @return whether {@link #getGradient} is known */
    default boolean hasGradient() {
        return isUniform();
    }

    /**
     * How the air's velocity changes from place to place, where a particle is. A uniform wind's does not.
     *
     * @param state    the particles' state, to be read only
     * @param time     t (s)
     * @param i        the particle
     * @param gradient receives 9 doubles by rows: entry 3 a + b is the derivative of component a by coordinate b (1/s)
     */
    default void getGradient(double[] state, double time, int i, double[] gradient) {
        Arrays.fill(gradient, 0);
    }
}
