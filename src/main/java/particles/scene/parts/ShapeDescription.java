package particles.scene.parts;

import static particles.spec.messages.Wording.quote;

import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.law.Scales;
import particles.scene.parts.SpringFamily.Sort;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Problems;
import particles.view.Scenery.Surface;

/**
 * One shape of a scene: a rope, a cloth, a block of jelly or a mesh.
 *
 * @param chosen its kind, with the values of its keys
 * @param layout its particles
 * @param fixed  the numbers of the fixed ones
 */
public record ShapeDescription(Chosen<ShapeKind> chosen, ParticleLayout layout, BitSet fixed) {
    /** The largest number of particles; they take about half a GiB. */
    public static final int MOST_PARTICLES = 1_000_000;

    /**
     * @param files    finds the files that shapes name
     * @param problems receives the problems
     * @return the shape, if it has no problem
     */
    public static Optional<ShapeDescription> of(Chosen<ShapeKind> chosen, NamedFiles files, Problems problems) {
        int before = problems.count();
        Optional<ShapeDescription> shape = chosen.kind().layout(chosen, files, problems)
                .map(layout -> new ShapeDescription(chosen, layout, new BitSet()));
        shape.ifPresent(made -> made.fixParticles(problems));
        return shape.filter(made -> problems.count() == before);
    }

    private Values values() {
        return chosen.values();
    }

    /** @return its particles, in the order of their numbers */
    public Stream<ParticleDescription> particles() {
        return IntStream.range(0, (int) layout.size()).mapToObj(this::particle);
    }

    /** @return one of its particles */
    public ParticleDescription particle(int n) {
        double mass = values().find(ShapeKind.MASS).orElseGet(() ->
                layout.mass(n, values().get(ShapeKind.TOTAL_MASS)));
        return new ParticleDescription(layout.idOf(n), layout.position(n), mass, fixed.get(n), values(),
                chosen.place());
    }

    /** @return the radius of each particle's ball (m), if it has one of its own */
    public Optional<Double> radius() {
        return values().find(ParticleDescription.RADIUS);
    }

    /** @return its springs */
    public List<SpringFamily> springs() {
        return Stream.of(Sort.values()).flatMap(sort -> values().find(sort.key()).stream()
                .map(family -> new SpringFamily(sort, family))).toList();
    }

    /**
     * Finds the scales of its particles, if it has any.
     *
     * @param first the index of its first particle in the system
     * @param all   receives the scales of each particle of the system
     */
    void putScales(int first, Scales[] all) {
        values().find(ShapeKind.SCALES).ifPresent(scales -> {
            int next = ((Lattice) layout).stride(0);
            for (int n = 0; n < layout.size(); n++) {
                int tail = first + (n + next < layout.size() ? n : n - next);
                all[first + n] = ShapeKind.scales(scales, tail, tail + next);
            }
        });
    }

    /**
     * @param first the index of its first particle in the system
     * @return its surface, if one is drawn
     */
    public Optional<Surface> surface(int first) {
        return values().get(ShapeKind.SURFACE)
                ? layout.surface(first, springs().stream().map(SpringFamily::sort).toList()) : Optional.empty();
    }

    private void fixParticles(Problems problems) {
        if (layout.size() > MOST_PARTICLES) {
            problems.add(chosen.place(), chosen.kind().getLabel() + " has " + layout.size()
                    + " particles; a scene may have at most " + MOST_PARTICLES);
            return;
        }
        new LinkedHashSet<>(values().get(ShapeKind.FIXED)).forEach(part -> fix(layout.numbers(part), ShapeKind.FIXED,
                "unknown particle " + quote(part) + " in 'fixed'; known: " + layout.parts(), problems));
        values().find(MeshShape.FIXED_BOX).ifPresent(box -> fix(IntStream.range(0, (int) layout.size()).filter(n ->
                MeshShape.isIn(box, layout.position(n))), MeshShape.FIXED_BOX, "no particle begins in 'fixedBox'",
                problems));
    }

    private void fix(IntStream numbers, Key<?> key, String ifNone, Problems problems) {
        if (numbers.peek(fixed::set).toArray().length == 0) {
            problems.add(values().place(key), ifNone);
        }
    }

    /** @return the number of its springs */
    public long springCount() {
        return springs().stream().mapToLong(family -> layout.pairs(family.sort())).sum();
    }
}
