package particles.effects;

import java.util.Arrays;

/**
 * A field of moving air. It exerts no force of its own: air drag asks it how fast the air moves past a particle.
 */
public interface Wind {
    /** Air at rest. */
    Wind STILL = (state, time, wind, from, to) -> Arrays.fill(wind, 3 * from, 3 * to, 0.0);

    /**
     * The velocity of the air where particles are.
     *
     * @param state the particles' state, to be read only
     * @param time  t (s)
     * @param wind  receives the air's velocity at particle i in the entries 3 i, 3 i + 1, 3 i + 2 (m/s)
     * @param from  first particle
     * @param to    one past the last particle
     */
    void getVelocities(double[] state, double time, double[] wind, int from, int to);

    /** @return whether the air moves in the same way everywhere, whatever the particles do */
    default boolean isUniform() {
        return false;
    }
}
