package particles.scene.parts;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.law.Scales;
import particles.law.Vector3;

/** Finds particles by id. Single particles come first in the state, then those of the shapes in order. */
public final class ParticleIndex {
    private final List<ParticleDescription> particles;
    private final List<ShapeDescription> shapes;
    /** The number of each single particle, and of the first one of each shape. */
    private final Map<String, Integer> numbers = new HashMap<>();
    private final Map<String, ShapeDescription> shapesById = new HashMap<>();
    private int count;

    /** Indexes single particles and shapes, in this order. */
    public ParticleIndex(List<ParticleDescription> particles, List<ShapeDescription> shapes) {
        this.particles = particles;
        this.shapes = shapes;
        for (ParticleDescription particle : particles) {
            numbers.put(particle.id(), count++);
        }
        for (ShapeDescription shape : shapes) {
            shapesById.put(shape.layout().id(), shape);
            numbers.put(shape.layout().id(), count);
            count += (int) shape.layout().size();
        }
    }

    /** @return the number of the particle with this id, if there is one */
    public Optional<Integer> find(String id) {
        return shape(shapeOf(id)).map(shape -> shape.layout().find(id).map(n -> numbers.get(shapeOf(id)) + n))
                .orElseGet(() -> Optional.ofNullable(numbers.get(id)));
    }

    /** @return the single particles */
    public List<ParticleDescription> getParticles() {
        return particles;
    }

    /** @return the shapes */
    public List<ShapeDescription> getShapes() {
        return shapes;
    }

    /** @return the indices of a shape's springs of one sort, all or within a part; those of all shapes come first */
    IntStream springs(String id, String sort, Optional<String> part) {
        IntStream.Builder found = IntStream.builder();
        int[] next = {0};
        for (ShapeDescription shape : shapes) {
            BitSet within = new BitSet();
            part.map(shape.layout()::numbers).orElseGet(() -> IntStream.range(0, (int) shape.layout().size()))
                    .forEach(within::set);
            for (SpringFamily family : shape.springs()) {
                boolean named = shape.layout().id().equals(id) && family.sort().key().name().equals(sort);
                shape.layout().forEachPair(family.sort(), (from, to) -> {
                    int spring = next[0]++;
                    if (named && within.get(from) && within.get(to)) {
                        found.add(spring);
                    }
                });
            }
        }
        return found.build();
    }

    /** @return the scales of each particle, null for one that has none; empty if no shape has any */
    public Scales[] scales() {
        boolean any = shapes.stream().anyMatch(shape -> shape.chosen().values().find(ShapeKind.SCALES).isPresent());
        Scales[] all = new Scales[any ? count : 0];
        shapes.forEach(shape -> shape.putScales(numbers.get(shape.layout().id()), all));
        return all;
    }

    /** @return the number of particles, those of shapes included */
    public int count() {
        return count;
    }

    /** @return the shape with this id, if there is one */
    public Optional<ShapeDescription> shape(String id) {
        return Optional.ofNullable(shapesById.get(id));
    }

    /** @return the part of an id before the brackets, which names the shape */
    public static String shapeOf(String id) {
        return id.contains("[") ? id.substring(0, id.indexOf('[')) : id;
    }

    /** @return the particle with this known id */
    public ParticleDescription particle(String id) {
        return shape(shapeOf(id)).map(shape -> shape.particle(shape.layout().find(id).orElseThrow()))
                .orElseGet(() -> particles.get(numbers.get(id)));
    }

    /** @return the initial position of the particle with this known id (m) */
    public Vector3 position(String id) {
        return particle(id).position();
    }

    /** @return the vector from one known particle to another at the start (m) */
    public Vector3 way(String from, String to) {
        return position(to).minus(position(from));
    }
}
