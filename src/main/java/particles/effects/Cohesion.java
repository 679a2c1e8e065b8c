package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.Set;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
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
 * <p>Forces are central and opposite, so momentum and angular momentum are conserved. Neighbours come from a {@link
 * NeighbourGrid}, rebuilt for all particles in every call, so that the work is proportional to their number; not
 * thread-safe. Source: the idea, B. Nixon and R. Lobb (2002); the potential is the Lennard-Jones law with the inverse
 * powers replaced by powers of u.
 */
public final class Cohesion implements DifferentiableEffect {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final NeighbourGrid grid = new NeighbourGrid();
    private final double range;
    private final double inverseSquare;                 // 1/h^2
    private final double depth;
    private final double scale;                         // 1/u0^4
    private final double damping;
    private final double[] r = new double[3];
    private final double[] w = new double[3];
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];
    private int[] near = {};

    /**
     * @param particles the particles on which it acts
     * @param range     h, the distance beyond which two particles exert no force on each other (m)
     * @param distance  d, the distance at which two are in balance (m), less than h
     * @param depth     e, the energy needed to separate a pair in balance (J), positive
     * @param damping   c, damping of the relative speed of a pair (N s/m), 0 or more
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Cohesion(Particles particles, double range, double distance, double depth, double damping) {
        if (!(distance > 0 && distance < range && range <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("cohesion's distance of balance has to be over 0 and less than"
                    + " its range, not "
                    + distance + " with a range of " + range);
        }
        if (!(depth > 0 && depth <= Double.MAX_VALUE && damping >= 0 && damping <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("cohesion needs a positive depth and a damping of 0 or more,"
                    + " not " + depth + ", "
                    + damping);
        }
        this.particles = particles;
        this.range = range;
        inverseSquare = 1 / (range * range);
        double u0 = 1 - distance * distance * inverseSquare;
        scale = 1 / (u0 * u0 * u0 * u0);
        this.depth = depth;
        this.damping = damping;
    }

    @Override
    public String getName() {
        return "cohesion";
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(Trait.INTERNAL, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT,
                damping > 0 ? Trait.DISSIPATIVE : Trait.CONSERVATIVE);
    }

    @Override
    public boolean dependsOnVelocity() {
        return damping > 0;
    }

    private void findNeighbours(double[] state) {
        int n = particles.count();
        if (near.length < n) {
            near = new int[n + n / 3];
        }
        grid.build(state, n, range);
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        findNeighbours(state);
        for (int p = 0; p < particles.count(); p++) {
            int i = STRIDE * p;
            int count = grid.findLater(p, near);
            for (int k = 0; k < count; k++) {
                int j = STRIDE * near[k];
                double rx = state[i] - state[j];
                double ry = state[i + 1] - state[j + 1];
                double rz = state[i + 2] - state[j + 2];
                double u = 1 - (rx * rx + ry * ry + rz * rz) * inverseSquare;
                if (u <= 0) {
                    continue;
                }
                double perLength = 2 * inverseSquare * slope(u);
                if (damping > 0) {
                    double parting = rx * (state[i + 3] - state[j + 3]) + ry * (state[i + 4] - state[j + 4])
                            + rz * (state[i + 5] - state[j + 5]);
                    perLength -= damping * u * u * inverseSquare * parting;
                }
                force[i + 3] += perLength * rx;
                force[i + 4] += perLength * ry;
                force[i + 5] += perLength * rz;
                force[j + 3] -= perLength * rx;
                force[j + 4] -= perLength * ry;
                force[j + 5] -= perLength * rz;
            }
        }
    }

    /** Derivative of a pair's potential with respect to u: 2 e (X - 1) dX/du. */
    private double slope(double u) {
        double cube = u * u * u * scale;
        return 8 * depth * (u * cube - 1) * cube;
    }

    /** Second derivative of it: e (56 u^6/u0^8 - 24 u^2/u0^4). */
    private double curvature(double u) {
        double square = u * u * scale;
        return depth * square * (56 * u * u * square - 24);
    }

    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        findNeighbours(state);
        for (int p = 0; p < particles.count(); p++) {
            int count = grid.findLater(p, near);
            for (int k = 0; k < count; k++) {
                double square = 0;
                double parting = 0;
                for (int c = 0; c < 3; c++) {
                    r[c] = state[STRIDE * p + c] - state[STRIDE * near[k] + c];
                    w[c] = state[STRIDE * p + 3 + c] - state[STRIDE * near[k] + 3 + c];
                    square += r[c] * r[c];
                    parting += r[c] * w[c];
                }
                double u = 1 - square * inverseSquare;
                if (u <= 0) {
                    continue;
                }
                double drag = damping * u * u * inverseSquare;
                double straight = 2 * inverseSquare * slope(u) - drag * parting;
                double outer = inverseSquare * inverseSquare * (4 * damping * u * parting - 4 * curvature(u));
                for (int e = 0; e < 9; e++) {
                    dFdX[e] = (e % 4 == 0 ? straight : 0) + outer * r[e / 3] * r[e % 3] - drag * r[e / 3] * w[e % 3];
                    dFdV[e] = -drag * r[e / 3] * r[e % 3];
                }
                derivatives.addPair(p, near[k], dFdX, dFdV);
            }
        }
    }

    @Override
    public double getPotentialEnergy(double[] state, double time) {
        return sum(state, false);
    }

    @Override
    public double getDissipatedPower(double[] state, double time) {
        return damping > 0 ? sum(state, true) : 0;
    }

    /** Sum over all pairs of the dissipated power or the potential energy. */
    private double sum(double[] state, boolean power) {
        findNeighbours(state);
        double sum = 0;
        for (int p = 0; p < particles.count(); p++) {
            int count = grid.findLater(p, near);
            for (int k = 0; k < count; k++) {
                double square = 0;
                double parting = 0;
                for (int c = 0; c < 3; c++) {
                    double r = state[STRIDE * p + c] - state[STRIDE * near[k] + c];
                    square += r * r;
                    parting += r * (state[STRIDE * p + 3 + c] - state[STRIDE * near[k] + 3 + c]);
                }
                double u = 1 - square * inverseSquare;
                if (u > 0) {
                    double x = u * u * u * u * scale;
                    sum += power ? damping * u * u * inverseSquare * parting * parting : depth * x * (x - 2);
                }
            }
        }
        return sum;
    }

    /** Cohesion in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Double> RANGE = Key.required("range", NumberType.positive("m"),
                "The distance beyond which two particles exert no force on each other (m).");
        private static final Key<Double> BALANCE = Key.withDefault("balance", NumberType.between(0.05, 0.95, ""), 0.6,
                "The fraction of the range at which two particles neither attract nor repel each other.");
        private static final Key<Double> DEPTH = Key.required("depth", NumberType.positive("J"),
                "The energy needed to separate two particles (J).");
        private static final Key<Double> DAMPING = Key.withDefault("damping", NumberType.notNegative("N s/m"), 0.0,
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
