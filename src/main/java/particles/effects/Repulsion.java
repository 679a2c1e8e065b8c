package particles.effects;

import java.util.List;
import java.util.Optional;
import particles.effects.neighbours.NeighbourLists;
import particles.law.CentralForce;
import particles.law.DivisibleEffect;
import particles.law.Particles;
import particles.law.Require;
import particles.spec.Key;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * Soft spheres: particles are balls that push each other apart where they overlap. With r = x_i - x_j and the overlap
 * d = R_i + R_j - |r|, the force along the line of centres is
 * <pre>
 *   F_i = k d^p max(0, 1 + b d') r / |r|      for d &gt; 0
 * </pre>
 * p = 1 for the linear law, 3/2 for Hertz's law of elastic balls; b is the bounce loss, as of {@link Penalty}. A pair
 * stores k d^(p + 1)/(p + 1). The force begins at 0, so it is continuous, and it is never attractive. Balls do not
 * spin, and there is no friction between them. Two balls with the same centre have no direction in which to push each
 * other: scenes and births with such balls are refused. Balls that pass through that point do not push each other
 * there.
 *
 * <p>Balls that meet with the speed v part with the speed w for which b v - ln(1 + b v) = -b w - ln(1 - b w), whatever
 * k, p and the masses are. That is about (1 - 2/3 b v) v for slow balls, and less than 1/b for any.
 *
 * <p>Without loss, a linear impact of two balls with reduced mass m takes pi sqrt(m/k); Hertz's takes 3.218 (m&sup2;
 * / (k&sup2; v))^(1/5), with v the speed of approach.
 *
 * <p>Neighbours come from {@link NeighbourLists}. The largest ball sets the search range of all, so one ball far larger
 * than the others makes it slow.
 *
 * <p>Source: P. Cundall, O. Strack, "A discrete numerical model for granular assemblies" (1979); of the damping, K.
 * Hunt, F. Crossley, "Coefficient of restitution interpreted as damping in vibroimpact" (1975).
 */
public final class Repulsion extends ShortRangeForce implements DivisibleEffect, CentralForce {
    private static final int PARTICLES_PER_BLOCK = 64;

    private final boolean hertz;
    private final double stiffness;
    private final double loss;

    /**
     * @param particles the particles that are balls
     * @param radius    the radius of each without one of its own (m), positive
     * @param hertz     whether Hertz's law holds
     * @param stiffness k (N/m, or N/m^1.5 for Hertz's law), positive
     * @param loss      b, the relative increase of the force per m/s of approach (s/m), 0 or more; 0 loses no energy
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Repulsion(Particles particles, double radius, boolean hertz, double stiffness, double loss) {
        super(particles, loss > 0, false, Require.positive("a ball's radius", radius));
        this.loss = Require.notNegative("repulsion's loss", loss);
        this.hertz = hertz;
        this.stiffness = Require.positive("repulsion's stiffness", stiffness);
    }

    /** Gives a particle a radius of its own (m), positive. */
    public void setRadius(int particle, double own) {
        put(particle, Require.positive("a ball's radius", own));
    }

    @Override
    public String getName() {
        return "repulsion";
    }

    @Override
    public void prepare(double[] state) {
        findNeighbours(state);
    }

    @Override
    int first(int i, boolean all) {
        return lists.first(i, all);
    }

    @Override
    public int countBlocks() {
        return Math.max(1, particles.count() / PARTICLES_PER_BLOCK);
    }

    @Override
    public int size() {
        return lists.size();
    }

    private int getFirstParticle(int block) {
        return (int) ((long) particles.count() * block / countBlocks());
    }

    /** {@inheritDoc} A block adds all forces on its particles, so there is no rest. */
    @Override
    public void addPart(int part, double[] state, double time, double[] force) {
        if (part < countBlocks()) {
            add(state, force, getFirstParticle(part), getFirstParticle(part + 1), true);
        }
    }

    @Override
    boolean reaches(int i, int j, double square) {
        double touching = radii[i] + radii[j];
        return square < touching * touching && square > 0;
    }

    @Override
    double perLength(int i, int j, double square, double parting) {
        double length = Math.sqrt(square);
        double inverse = 1 / length;
        return elastic(radii[i] + radii[j] - length) * Math.max(0, 1 - loss * parting * inverse) * inverse;
    }

    /** k d^p. */
    private double elastic(double overlap) {
        return stiffness * overlap * (hertz ? Math.sqrt(Math.max(0, overlap)) : 1);
    }

    @Override
    double potential(int i, int j, double square) {
        double overlap = radii[i] + radii[j] - Math.sqrt(square);
        return elastic(overlap) * overlap / (hertz ? 2.5 : 2);
    }

    @Override
    double bySquare(int i, int j, double square, double parting) {
        double length = Math.sqrt(square);
        double increase = 1 - loss * parting / length;
        if (increase <= 0) {
            return 0;
        }
        double overlap = radii[i] + radii[j] - length;
        double slope = hertz ? 1.5 * stiffness * Math.sqrt(Math.max(0, overlap)) : stiffness;
        return (elastic(overlap) / length * (loss * parting / length - increase) - slope * increase) / (2 * square);
    }

    @Override
    double byParting(int i, int j, double square, double parting) {
        double length = Math.sqrt(square);
        return loss * parting < length ? -loss * elastic(radii[i] + radii[j] - length) / square : 0;
    }

    @Override
    public Optional<String> findUndirected(double[] state, int first) {
        return findAtOnePlace(state, first).map(pair -> pair
                + "; soft balls there have no direction in which to push each other");
    }

    /** Repulsion in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<String> LAW = NameType.of("law", List.of("linear", "hertz"))
                .withDefault("law", "linear",
                "linear: the push is k times the overlap d; hertz: k d^1.5, as of elastic balls.");
        private static final Key<Double> STIFFNESS = NumberType.positive("N/m").required("stiffness",
                "k (N/m; for hertz N/m^1.5).");
        private static final Key<Double> LOSS = NumberType.notNegative("s/m").withDefault("loss", 0.0,
                "b (s/m): at overlap d and speed of approach v the push is k d (1 + b v), and never negative;"
                + " balls that meet slowly, at v, part at about v (1 - 2/3 b v); 0 loses no energy.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("repulsion", "Particles are soft balls that push each other apart where they overlap.",
                    SharedKeys.BALL_RADIUS, LAW, STIFFNESS, LOSS);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            Repulsion repulsion = new Repulsion(scene.particles(), values.get(SharedKeys.BALL_RADIUS),
                    values.get(LAW).equals("hertz"), values.get(STIFFNESS), values.get(LOSS));
            for (int i = 0; i < scene.particles().count(); i++) {
                int particle = i;
                scene.ownRadius(i).ifPresent(own -> repulsion.setRadius(particle, own));
            }
            scene.add(repulsion);
        }
    }
}
