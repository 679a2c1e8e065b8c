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
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Place;
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
        ShapeKind kind = chosen.kind();
        Optional<ParticleLayout> layout = kind.layout(chosen, files, problems);
        if (layout.isEmpty()) {
            return Optional.empty();
        }
        if (layout.get().size() > MOST_PARTICLES) {
            return problems.add(chosen.place(), kind.getLabel() + " has " + layout.get().size()
                    + " particles; a scene may have at most " + MOST_PARTICLES);
        }
        ShapeDescription shape = new ShapeDescription(chosen, layout.get(), new BitSet());
        int before = problems.count();
        new LinkedHashSet<>(shape.values().get(ShapeKind.FIXED)).forEach(part -> shape.fix(part, problems));
        shape.values().find(MeshShape.FIXED_BOX).ifPresent(box -> shape.fix(shape.numbersIn(box),
                shape.values().place(MeshShape.FIXED_BOX), "no particle begins in 'fixedBox'", problems));
        return problems.count() > before ? Optional.empty() : Optional.of(shape);
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

    private IntStream numbersIn(Values box) {
        return IntStream.range(0, (int) layout.size()).filter(n -> MeshShape.isIn(box, layout.position(n)));
    }

    private void fix(String part, Problems problems) {
        fix(layout.numbers(part), values().place(ShapeKind.FIXED), "unknown particle " + quote(part)
                + " in 'fixed'; known: " + layout.parts(), problems);
    }

    private void fix(IntStream numbers, Place place, String ifNone, Problems problems) {
        int[] found = numbers.peek(fixed::set).toArray();
        if (found.length == 0) {
            problems.add(place, ifNone);
        }
    }

    /** @return the number of its springs */
    public long springCount() {
        return springs().stream().mapToLong(family -> layout.pairs(family.sort())).sum();
    }
}
