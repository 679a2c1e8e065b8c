package particles.scene.parts;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import particles.law.Vector3;
import particles.scene.parts.SpringFamily.Sort;
import particles.spec.Chosen;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * One shape of a scene: a rope, a cloth or a block of jelly.
 *
 * @param lattice  its particles
 * @param mass     the mass of each (kg)
 * @param velocity the initial velocity of the free ones (m/s)
 * @param fixed    the numbers of the fixed ones
 * @param springs  its springs
 * @param surface  whether it is drawn as a surface
 * @param radius   the radius of each particle's ball (m), if it has one of its own
 * @param place    its place in the file
 */
public record ShapeDescription(Lattice lattice, double mass, Vector3 velocity, BitSet fixed, List<SpringFamily> springs,
                        boolean surface, Optional<Double> radius, Place place) {
    /** The largest number of particles; they take about half a GiB. */
    public static final int MOST_PARTICLES = 1_000_000;

    /** @return the shape, if it has no problem */
    public static Optional<ShapeDescription> of(Chosen<ShapeKind> chosen, Problems problems) {
        ShapeKind kind = chosen.kind();
        Values values = chosen.values();
        Lattice lattice = kind.lattice(values);
        if (lattice.size() > MOST_PARTICLES) {
            return problems.add(chosen.place(), "'" + kind.getName() + "' has " + lattice.size()
                    + " particles; a scene may have at most "
                    + MOST_PARTICLES);
        }
        if (!(lattice.flatness() > 1e-9)) {
            return problems.add(chosen.place(), "'" + kind.getName()
                    + "' has no extent in one direction: its particles would lie on top of each other");
        }
        BitSet fixed = new BitSet();
        int before = problems.count();
        for (String part : new LinkedHashSet<>(values.get(ShapeKind.FIXED))) {
            addPart(part, lattice, kind, fixed, values.place(ShapeKind.FIXED), problems);
        }
        if (problems.count() > before) {
            return Optional.empty();
        }
        double mass = values.find(ShapeKind.MASS).orElseGet(() -> values.get(ShapeKind.TOTAL_MASS) / lattice.size());
        List<SpringFamily> springs = new ArrayList<>();
        for (Sort sort : Sort.values()) {
            values.find(sort.key()).ifPresent(family -> springs.add(SpringFamily.of(sort, family)));
        }
        boolean surface = lattice.counts().size() > 1 && values.get(ShapeKind.SURFACE);
        return Optional.of(new ShapeDescription(lattice, mass, values.get(ShapeKind.VELOCITY), fixed, springs, surface,
                values.find(ParticleDescription.RADIUS), chosen.place()));
    }

    /** @return one of its particles */
    public ParticleDescription particle(int n) {
        return new ParticleDescription(lattice.idOf(n), lattice.position(n), fixed.get(n) ? Vector3.ZERO : velocity,
                mass, fixed.get(n), radius, place);
    }

    private static void addPart(String part, Lattice lattice, ShapeKind kind, BitSet fixed, Place place,
            Problems problems) {
        if (part.endsWith("]")) {
            OptionalInt number = lattice.find(part);
            if (number.isEmpty()) {
                problems.add(place, "unknown particle " + Wording.quote(part)
                        + " in 'fixed'; known: " + lattice.range());
            }
            number.ifPresent(fixed::set);
            return;
        }
        for (int n = 0; n < lattice.size(); n++) {
            List<String> sides = kind.sidesOf(lattice.indices(n), lattice.counts());
            if (switch (part) {
                case "corners" -> sides.size() == lattice.counts().size();
                case "edges" -> !sides.isEmpty();
                default -> sides.containsAll(List.of(part.split("-")));
            }) {
                fixed.set(n);
            }
        }
    }

    /** @return the number of its springs */
    public long springCount() {
        return springs.stream().mapToLong(family -> family.count(lattice)).sum();
    }
}
