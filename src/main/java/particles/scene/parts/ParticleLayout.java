package particles.scene.parts;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.scene.parts.SpringFamily.Sink;
import particles.scene.parts.SpringFamily.Sort;
import particles.view.Scenery.Surface;

/** The particles of a shape: their names, where they are, which are neighbours, and the surface that they span. */
public interface ParticleLayout {
    /** @return the shape's name, with which the names of its particles begin */
    String id();

    /** @return the number of particles */
    long size();

    /** @return the name of particle n */
    String idOf(int n);

    /** @return the number of the particle with this name, if it is one of the shape */
    default Optional<Integer> find(String particle) {
        String number = particle.replaceFirst(".*\\[(\\d{1,9})]$", "$1");
        return Optional.of(number).filter(text -> text.length() < particle.length()).map(Integer::valueOf)
                .filter(n -> n < size() && idOf(n).equals(particle));
    }

    /** @return the position of particle n (m) */
    Vector3 position(int n);

    /** @return the mass of particle n if all together have the mass {@code total} (kg) */
    double mass(int n, double total);

    /** @return the numbers of the particles that a part's name or a particle's id stands for; empty if neither */
    IntStream numbers(String part);

    /** @return the range of ids, for messages */
    default String range() {
        return idOf(0) + " to " + idOf((int) size() - 1);
    }

    /** @return the range of ids and the names of parts, for messages */
    default String parts() {
        return range();
    }

    /** @return the number of pairs of neighbours of this sort */
    long pairs(Sort sort);

    /** Passes every pair of neighbours of this sort to a sink, once. */
    void forEachPair(Sort sort, Sink sink);

    /**
     * @param first the index of its first particle in the system
     * @param sorts the sorts of springs that it has
     * @return the surface that its particles span, if they span one
     */
    Optional<Surface> surface(int first, List<Sort> sorts);

    /** @return remarks for the person who made the shape, one line each */
    default List<String> remarks() {
        return List.of();
    }
}
