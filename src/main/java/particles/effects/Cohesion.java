package particles.effects;

import particles.effects.neighbours.NeighbourLists;
import particles.law.Particles;
import particles.law.Require;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * Cohesion: a pair force that repels at short range and attracts at longer range, so that a heap of particles holds
 * together like a drop. With r = x_i - x_j, range h, and
 * <pre>
 *   u = 1 - |r|^2 / h^2,     X = (u / u0)^4,     u0 = u at the distance d of balance
 *   potential of the pair  = e (X^2 - 2 X)       for |r| &lt; h, 0 beyond
 *   damping of the pair    : F_i = -c u^2 (r . r') r / h^2
 * </pre>
 * The potential is -e at the distance d, where the force is 0, and is smooth everywhere: at |r| = 0 the force is 0, and
 * at |r| = h it goes to 0 as u&sup3;, so that solvers keep their order as neighbours come and go.
 *
 * <p>Neighbours come from {@link NeighbourLists}, so that the work is proportional to their number. Source: the idea,
 * B. Nixon and R. Lobb (2002); the potential is the Lennard-Jones law with the inverse powers replaced by powers of u.
 */
public final class Cohesion extends ShortRangeForce {
    private final double range;
    private final double inverseSquare;                 // 1/h^2
    private final double depth;
    private final double damping;
    private final double scale;                         // 1/u0^4

    /**
     * @param particles the particles on which it acts
     * @param range     h, the distance beyond which two particles exert no force on each other (m)
     * @param distance  d, the distance at which two are in balance (m), less than h
     * @param depth     e, the energy needed to separate a pair in balance (J), positive
     * @param damping   c, damping of the relative speed of a pair (N s/m), 0 or more
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Cohesion(Particles particles, double range, double distance, double depth, double damping) {
        super(particles, damping > 0, true, range / 2);
        if (!(distance > 0 && distance < range && range <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("cohesion's distance of balance has to be over 0 and less than"
                    + " its range, not "
                    + distance + " with a range of " + range);
        }
        this.damping = Require.notNegative("cohesion's damping", damping);
        this.range = range;
        inverseSquare = 1 / (range * range);
        double u0 = 1 - distance * distance * inverseSquare;
        scale = 1 / (u0 * u0 * u0 * u0);
        this.depth = Require.positive("cohesion's depth", depth);
    }

    @Override
    public String getName() {
        return "cohesion";
    }

    @Override
    void findNeighbours(double[] state) {
        super.findNeighbours(state);
        lists.sortByCubes(state, range);
    }

    @Override
    int first(int i, boolean all) {
        return lists.first(i, false);
    }

    private double u(double square) {
        return 1 - square * inverseSquare;
    }

    @Override
    boolean reaches(int i, int j, double square) {
        return u(square) > 0;
    }

    @Override
    double perLength(int i, int j, double square, double parting) {
        double u = u(square);
        // the slope first: the page's compiler drops the brackets of a product on the right
        double perLength = slope(u) * 2 * inverseSquare;
        return damping > 0 ? perLength - damping * u * u * inverseSquare * parting : perLength;
    }

    /** Derivative of a pair's potential with respect to u: 2 e (X - 1) dX/du. */
    private double slope(double u) {
        double cube = u * u * u * scale;
        return 8 * depth * (u * cube - 1) * cube;
    }

    /** {@inheritDoc} The second derivative of the potential is e (56 u^6/u0^8 - 24 u^2/u0^4). */
    @Override
    double bySquare(int i, int j, double square, double parting) {
        double u = u(square);
        double part = u * u * scale;
        double curvature = depth * part * (56 * u * u * part - 24);
        return 2 * inverseSquare * inverseSquare * (damping * u * parting - curvature);
    }

    @Override
    double byParting(int i, int j, double square, double parting) {
        double u = u(square);
        return -damping * u * u * inverseSquare;
    }

    @Override
    double potential(int i, int j, double square) {
        double u = u(square);
        double x = u * u * u * u * scale;
        return depth * x * (x - 2);
    }

    /** Cohesion in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Double> RANGE = NumberType.positive("m").required("range",
                "The distance beyond which two particles exert no force on each other (m).");
        private static final Key<Double> BALANCE = NumberType.between(0.05, 0.95, "").withDefault("balance", 0.6,
                "The fraction of the range at which two particles neither attract nor repel each other.");
        private static final Key<Double> DEPTH = NumberType.positive("J").required("depth",
                "The energy needed to separate two particles (J).");
        private static final Key<Double> DAMPING = NumberType.notNegative("N s/m").withDefault("damping", 0.0,
                "Damps the relative motion of two near particles along the line between them (N s/m).");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("cohesion", "Particles attract each other at a distance and repel each other close by, so"
                    + " that many hold together like a drop.", RANGE, BALANCE, DEPTH, DAMPING);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            double range = values.get(RANGE);
            scene.add(new Cohesion(scene.particles(), range, range * values.get(BALANCE), values.get(DEPTH),
                    values.get(DAMPING)));
        }
    }
}
