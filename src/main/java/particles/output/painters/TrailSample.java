package particles.output.painters;

import java.util.Map;
import java.util.Optional;
import particles.law.Vector3;

/**
 * The positions of all particles at a time; nobody changes it any more, so that threads can share it.
 *
 * @param time    the time (s)
 * @param places  three entries a particle (m)
 * @param indices the index of each particle in them, by its id
 */
public record TrailSample(double time, float[] places, Map<String, Integer> indices) {

    /** @return where a particle was (m); empty if it was not there */
    public Optional<Vector3> place(String id) {
        return Optional.ofNullable(indices.get(id)).map(i ->
                new Vector3(places[3 * i], places[3 * i + 1], places[3 * i + 2]));
    }
}
