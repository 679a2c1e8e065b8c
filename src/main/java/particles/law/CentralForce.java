package particles.law;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * A force law that pushes particles along the line between them, however near they are. It says nothing of two with the
 * same centre: scenes and births with such particles are refused.
 */
public interface CentralForce extends Effect {

    /** @return the particles on which it acts */
    Particles getParticles();

    /**
     * Looks for two particles with the same centre.
     *
     * @param state the particles' state
     * @param first looks for particles from this one on, at the place of any other; two fixed ones do not count
     * @return their indices, if there are any
     */
    default Optional<int[]> findAtOnePlace(double[] state, int first) {
        Particles particles = getParticles();
        Map<Vector3, Integer> places = new HashMap<>();
        for (int i = 0; i < particles.count(); i++) {
            Vector3 place = Vector3.at(state, Particles.STRIDE * i).plus(Vector3.ZERO);     // -0 becomes 0
            Integer other = places.put(place, i);
            if (other != null && i >= first && !(particles.isFixed(i) && particles.isFixed(other))) {
                return Optional.of(new int[] {other, i});
            }
        }
        return Optional.empty();
    }
}
