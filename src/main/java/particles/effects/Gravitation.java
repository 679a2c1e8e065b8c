package particles.effects;

import java.util.Optional;
import particles.law.CentralForce;
import particles.law.DivisibleEffect;
import particles.law.Particles;
import particles.law.Require;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * Gravitation between all particles: with r = x_i - x_j, each pair attracts each other by
 * <pre>
 *   F_i = -G m_i m_j r / (|r|^2 + s^2)^(3/2)
 * </pre>
 * and stores -G m_i m_j / sqrt(|r|&sup2; + s&sup2;). Fixed particles attract, too. Without softening (s = 0) the force
 * is Newton's, and two particles at the same place have no direction in which to attract each other: unless both are
 * fixed, scenes and births with such particles are refused. With s &gt; 0 the force falls to 0 within about s, so that
 * particles can pass through each other with reasonable steps.
 *
 * <p>The work grows as the square of the number of particles. Source of the softening: H. Plummer (1911), S. Aarseth
 * (1963).
 */
public final class Gravitation extends PairForce implements DivisibleEffect, CentralForce {
    /** Each block has this many forces on each of its particles, so few are enough. */
    private static final int PARTICLES_PER_BLOCK = 16;

    /** From this number on an evaluation takes some hundredths of a second, and a run warns. */
    private static final int MANY = 3000;

    private final double strength;
    private final double softeningSquare;

    /**
     * @param particles the particles that attract each other
     * @param strength  G (N m&sup2;/kg&sup2;), positive
     * @param softening s (m), 0 or more
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Gravitation(Particles particles, double strength, double softening) {
        super(particles, false);
        this.strength = Require.positive("the constant of gravitation", strength);
        softeningSquare = softening * Require.notNegative("softening", softening);
    }

    @Override
    public String getName() {
        return "gravitation";
    }

    /** {@inheritDoc} With softening there is no force between them, whatever its direction. */
    @Override
    public Optional<String> findUndirected(double[] state, int first) {
        return softeningSquare > 0 ? Optional.empty() : findAtOnePlace(state, first).map(pair -> pair
                + "; without softening they have no direction in which to attract each other");
    }

    @Override
    public void prepare(double[] state) {
        findNeighbours(state);
    }

    /** All particles are near all others. */
    @Override
    void findNeighbours(double[] state) {
        if (near.length != particles.count()) {
            near = new int[particles.count()];
            for (int i = 0; i < near.length; i++) {
                near[i] = i;
            }
        }
    }

    @Override
    int first(int i, boolean all) {
        return all ? 0 : i + 1;
    }

    @Override
    int end(int i) {
        return near.length;
    }

    @Override
    boolean reaches(int i, int j, double square) {
        return i != j && square + softeningSquare > 0;          // two fixed ones may be at one place
    }

    @Override
    public int countBlocks() {
        return Math.max(1, particles.count() / PARTICLES_PER_BLOCK);
    }

    @Override
    public int size() {
        return (int) Math.min(Integer.MAX_VALUE, (long) near.length * near.length);
    }

    /** {@inheritDoc} A block adds all forces on its particles, so there is no rest. */
    @Override
    public void addPart(int part, double[] state, double time, double[] force) {
        if (part < countBlocks()) {
            long n = near.length;
            add(state, force, (int) (n * part / countBlocks()), (int) (n * (part + 1) / countBlocks()), true);
        }
    }

    /** {@inheritDoc} The time to pass a particle: twice the softened distance over the relative speed. */
    @Override
    public double getShortestTime(double[] state, double time) {
        double[] shortest = {Double.POSITIVE_INFINITY};
        forEachPair(state, (i, j, square, parting) -> {
            double speed = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
            shortest[0] = Math.min(shortest[0], speed > 0 ? 2 * Math.sqrt((square + softeningSquare) / speed)
                    : Double.POSITIVE_INFINITY);
        });
        return shortest[0];
    }

    @Override
    double perLength(int i, int j, double square, double parting) {
        double soft = square + softeningSquare;
        return -strength * particles.mass(i) * particles.mass(j) / (soft * Math.sqrt(soft));
    }

    @Override
    double potential(int i, int j, double square) {
        return -strength * particles.mass(i) * particles.mass(j) / Math.sqrt(square + softeningSquare);
    }

    @Override
    double bySquare(int i, int j, double square, double parting) {
        return -1.5 * perLength(i, j, square, parting) / (square + softeningSquare);
    }

    @Override
    double byParting(int i, int j, double square, double parting) {
        return 0;
    }

    /** Gravitation in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Double> STRENGTH = NumberType.positive("N m^2/kg^2").withDefault("constant",
                6.6743e-11, "G (N m^2/kg^2): the force is G m1 m2/r^2; the default is that of nature.");
        private static final Key<Double> SOFTENING = NumberType.notNegative("m").withDefault("softening", 0.0,
                "s (m): the force is G m1 m2 r/(r^2 + s^2)^1.5, so that particles can pass through each other.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("gravitation", "All particles attract each other, as stars do.", STRENGTH, SOFTENING);
        }

        @Override
        public Optional<String> remark(int particles) {
            return particles < MANY ? Optional.empty() : Optional.of("warning: gravitation between " + particles
                    + " particles adds " + particles * (particles - 1L) / 2
                    + " pairs to each evaluation: its time grows as the square of their number");
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new Gravitation(scene.particles(), values.get(STRENGTH), values.get(SOFTENING)));
        }
    }
}
