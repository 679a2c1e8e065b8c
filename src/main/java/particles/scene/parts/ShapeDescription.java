package particles.scene.parts;

import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.scene.parts.SpringFamily.Sort;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * One shape of a scene: a rope, a cloth or a block of jelly.
 *
 * @param chosen  its kind, with the values of its keys
 * @param lattice its particles
 * @param fixed   the numbers of the fixed ones
 */
public record ShapeDescription(Chosen<ShapeKind> chosen, Lattice lattice, BitSet fixed) {
    /** The largest number of particles; they take about half a GiB. */
    public static final int MOST_PARTICLES = 1_000_000;

    /** @return the shape, if it has no problem */
    public static Optional<ShapeDescription> of(Chosen<ShapeKind> chosen, Problems problems) {
        ShapeKind kind = chosen.kind();
        Values values = chosen.values();
        Lattice lattice = kind.lattice(values);
        if (lattice.size() > MOST_PARTICLES) {
            return problems.add(chosen.place(), kind.getLabel() + " has " + lattice.size()
                    + " particles; a scene may have at most " + MOST_PARTICLES);
        }
        if (!(lattice.flatness() > 1e-9)) {
            return problems.add(chosen.place(), kind.getLabel()
                    + " has no extent in one direction: its particles would lie on top of each other");
        }
        ShapeDescription shape = new ShapeDescription(chosen, lattice, new BitSet());
        int before = problems.count();
        new LinkedHashSet<>(values.get(ShapeKind.FIXED)).forEach(part -> shape.fix(part, problems));
        return problems.count() > before ? Optional.empty() : Optional.of(shape);
    }

    private Values values() {
        return chosen.values();
    }

    /** @return its particles, in the order of their numbers */
    public Stream<ParticleDescription> particles() {
        return IntStream.range(0, (int) lattice.size()).mapToObj(this::particle);
    }

    /** @return one of its particles */
    public ParticleDescription particle(int n) {
        double mass = values().find(ShapeKind.MASS).orElseGet(() -> values().get(ShapeKind.TOTAL_MASS)
                / lattice.size());
        return new ParticleDescription(lattice.idOf(n), lattice.position(n), mass, fixed.get(n), values(),
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

    /** @return whether it is drawn as a surface */
    public boolean surface() {
        return lattice.counts().size() > 1 && values().get(ShapeKind.SURFACE);
    }

    private void fix(String part, Problems problems) {
        if (part.endsWith("]")) {
            Optional<Integer> number = lattice.find(part);
            if (number.isEmpty()) {
                problems.add(values().place(ShapeKind.FIXED), "unknown particle " + Wording.quote(part)
                        + " in 'fixed'; known: " + lattice.range());
            }
            number.ifPresent(fixed::set);
            return;
        }
        List<String> together = List.of(part.split("-"));
        for (int n = 0; n < lattice.size(); n++) {
            List<String> sides = chosen.kind().sidesOf(lattice.indices(n), lattice.counts());
            if (switch (part) {
                case "corners" -> sides.size() == lattice.counts().size();
                case "edges" -> !sides.isEmpty();
                default -> sides.containsAll(together);
            }) {
                fixed.set(n);
            }
        }
    }

    /** @return the number of its springs */
    public long springCount() {
        return springs().stream().mapToLong(family -> family.count(lattice)).sum();
    }
}
