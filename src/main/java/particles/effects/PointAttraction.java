package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.Optional;
import java.util.Set;
import particles.law.BriefForce;
import particles.law.CentralForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.PerParticleEffect;
import particles.law.Require;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * Attraction by a fixed point, as of planets by the sun: with r the vector from the point to the particle,
 * <pre>
 *   F = -m mu r / (|r|^2 + s^2)^(3/2)
 * </pre>
 * mu is G times the mass at the point. Without softening (s = 0) orbits are Kepler's ellipses, and the force is
 * infinite at the point itself. With s &gt; 0 the force falls to 0 within about s of the point, so that particles can
 * pass through it with reasonable steps, and ellipses precess slowly.
 *
 * <p>Potential energy -m mu / sqrt(|r|&sup2; + s&sup2;). Source of the softening: H. Plummer (1911), S. Aarseth (1963).
 */
public final class PointAttraction implements PerParticleEffect, DifferentiableEffect, BriefForce,
        CentralForce {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final Vector3 centre;
    private final double strength;
    private final double softeningSquare;
    private final double[] r = new double[3];
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];            // stays 0

    /**
     * @param particles the particles on which it acts
     * @param centre    the point (m)
     * @param strength  mu (m&sup3;/s&sup2;); negative repels
     * @param softening s (m), 0 or more
     * @throws IllegalArgumentException if a number is not finite or the softening negative
     */
    public PointAttraction(Particles particles, Vector3 centre, double strength, double softening) {
        if (!Double.isFinite(strength)) {
            throw new IllegalArgumentException("an attraction needs a finite strength, not " + strength);
        }
        this.particles = particles;
        this.centre = centre.requireFinite("the centre of attraction");
        this.strength = strength;
        softeningSquare = softening * Require.notNegative("softening", softening);
    }

    @Override
    public String getName() {
        return "attraction";
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(Trait.CONSERVATIVE);
    }

    @Override
    public boolean dependsOnVelocity() {
        return false;
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double[] masses = particles.getMasses();
        for (int i = from, x = STRIDE * from; i < to; i++, x += STRIDE) {
            if (particles.isFixed(i)) {
                continue;                               // a sun that is drawn may stand at the very centre
            }
            double rx = state[x] - centre.x();
            double ry = state[x + 1] - centre.y();
            double rz = state[x + 2] - centre.z();
            double square = rx * rx + ry * ry + rz * rz + softeningSquare;
            double pull = masses[i] * strength / (square * Math.sqrt(square));
            force[x + 3] -= pull * rx;
            force[x + 4] -= pull * ry;
            force[x + 5] -= pull * rz;
        }
    }

    /** Writes r of the particle whose state begins at x; returns |r|&sup2; + s&sup2;. */
    private double findPlace(double[] state, int x) {
        r[0] = state[x] - centre.x();
        r[1] = state[x + 1] - centre.y();
        r[2] = state[x + 2] - centre.z();
        return r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + softeningSquare;
    }

    @Override
    public Optional<String> findUndirected(double[] state, int first) {
        return particles.free().filter(i -> i >= first && findPlace(state, STRIDE * i) == 0).mapToObj(i -> "'"
                + particles.id(i) + "' is at the point that attracts it; without softening the force there has no"
                + " direction").findFirst();
    }

    /** {@inheritDoc} From a particle to the other side of the point, as far away, or within its softening. */
    @Override
    public double getShortestTime(double[] state, double time) {
        double shortest = Double.POSITIVE_INFINITY;
        for (int i = 0, x = 0; i < particles.count(); i++, x += STRIDE) {
            double square = state[x + 3] * state[x + 3] + state[x + 4] * state[x + 4] + state[x + 5] * state[x + 5];
            if (square > 0 && !particles.isFixed(i)) {
                shortest = Math.min(shortest, 2 * Math.sqrt(findPlace(state, x) / square));
            }
        }
        return shortest;
    }

    /** {@inheritDoc} dF/dx = -m mu (1 - 3 r r<sup>T</sup>/q&sup2;)/q&sup3; with q&sup2; = |r|&sup2; + s&sup2;. */
    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (int i = 0, x = 0; i < particles.count(); i++, x += STRIDE) {
            if (particles.isFixed(i)) {
                continue;
            }
            double square = findPlace(state, x);
            double pull = particles.mass(i) * strength / (square * Math.sqrt(square));
            for (int e = 0; e < 9; e++) {
                dFdX[e] = pull * (3 * r[e / 3] * r[e % 3] / square - (e % 4 == 0 ? 1 : 0));
            }
            derivatives.add(i, i, dFdX, dFdV);
        }
    }

    /** {@inheritDoc} Fixed particles are left out. */
    @Override
    public double getPotentialEnergy(double[] state, double time) {
        return 0 - particles.sumOfFree(i -> particles.mass(i) * strength / Math.sqrt(findPlace(state, STRIDE * i)));
    }

    /** Attraction by a point in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Double> STRENGTH = NumberType.any("m^3/s^2").required("strength",
                "mu (m^3/s^2): at the distance r the acceleration is mu / r^2; a negative mu repels.");
        private static final Key<Vector3> CENTRE = VectorType.of("m").withDefault("centre", Vector3.ZERO,
                "The point that attracts (m).");
        private static final Key<Double> SOFTENING = NumberType.notNegative("m").withDefault("softening", 0.0,
                "s (m): the acceleration is mu r / (r^2 + s^2)^1.5, so that particles can pass through the centre.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("attraction", "Attracts every particle to a point, as the sun does.", STRENGTH, CENTRE, SOFTENING);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new PointAttraction(scene.particles(), values.get(CENTRE), values.get(STRENGTH),
                    values.get(SOFTENING)));
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }
}
