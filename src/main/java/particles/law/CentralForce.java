package particles.law;

import java.util.Optional;

/**
 * A force law along the line to a point or to another particle, which has no direction where the two coincide: scenes
 * and births that put a particle there are refused.
 */
public interface CentralForce extends Effect {

    /**
     * Looks for a particle at a place where the force on it has no direction.
     *
     * @param state the particles' state
     * @param first looks for particles from this one on
     * @return which particle is where, for a message, if there is any
     */
    Optional<String> findUndirected(double[] state, int first);
}
