package particles.effects;

import deSolvers.ForceDerivatives;
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
 * A magnetic field B that acts on moving charges:
 * <pre>
 *   F = q v x B
 * </pre>
 * The force is at right angles to the velocity, so it does no work. In a uniform field particles go round the field's
 * lines with omega = q |B|/m, whatever their speed, on circles of radius v/omega.
 *
 * <p>A magnetic bottle has a length L: with z along the axis e from its centre and the vector r at right angles to it,
 * <pre>
 *   B = B0 (e (1 + (z^2 - |r|^2/2)/L^2) - r z/L^2)
 * </pre>
 * It has neither divergence nor curl. Where the lines come together, at both ends, particles that go round them turn
 * back, since the flux through their circle stays about the same (the first adiabatic invariant).
 *
 * <p>The acceleration depends on the velocity. {@link deSolvers.symplectic.VelocityVerletSolver} and {@link
 * deSolvers.symplectic.Yoshida4Solver} take the closing half kick implicitly, so that in a uniform field a step turns
 * the velocity by a Cayley transform, as Boris's method does: the speed stays the same. In a bottle its relative error
 * is bounded, about (omega deltaT)&sup2;/8. The iteration for the kick converges for omega deltaT below about 1.5, or
 * 0.8 with yoshida4; beyond, a step fails. With the explicit kick of {@link deSolvers.symplectic.SymplecticEulerSolver}
 * the speed grows by a factor of sqrt(1 + (omega deltaT)&sup2;) in each step.
 *
 * <p>Source: J. Boris, "Relativistic plasma simulation" (1970); of the bottle, the first terms of a mirror field, T.
 * Northrop, "The adiabatic motion of charged particles" (1963).
 */
public final class MagneticField implements PerParticleEffect, DifferentiableEffect {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final double charge;
    private final Vector3 centre;
    private final Vector3 axis;
    private final double strength;
    private final double curvature;                     // 1/L^2
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];

    /**
     * @param particles the particles, which all have the same charge
     * @param charge    q (C)
     * @param field     B0, the field at the centre (T), not 0
     * @param centre    the centre of the bottle (m)
     * @param length    L (m), positive; infinite for a uniform field
     * @throws IllegalArgumentException if a number is out of its range
     */
    public MagneticField(Particles particles, double charge, Vector3 field, Vector3 centre, double length) {
        this.particles = particles;
        if (!Double.isFinite(charge)) {
            throw new IllegalArgumentException("a charge has to be finite, not " + charge);
        }
        this.charge = charge;
        this.centre = centre.requireFinite("the centre of a magnetic field");
        axis = field.normalized();
        strength = field.length();
        curvature = length == Double.POSITIVE_INFINITY ? 0
                : 1 / (length * Require.positive("the length of a magnetic bottle", length));
    }

    @Override
    public String getName() {
        return "magneticField";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        for (int x = STRIDE * from; x < STRIDE * to; x += STRIDE) {
            Vector3 push = Vector3.at(state, x + 3).cross(field(Vector3.at(state, x))).times(charge);
            Vector3.at(force, x + 3).plus(push).put(force, x + 3);
        }
    }

    /** B at a place (T), with r = d - z e, where d is the vector from the centre. */
    private Vector3 field(Vector3 place) {
        Vector3 d = place.minus(centre);
        double z = axis.dot(d);
        return axis.times(strength * (1 + curvature * (2.5 * z * z - d.dot(d) / 2)))
                .minus(d.times(strength * curvature * z));
    }

    /**
     * {@inheritDoc} With the b-th unit vector u, dB/dx<sub>b</sub> = B0/L&sup2; ((5 z e<sub>b</sub> - d<sub>b</sub>) e
     * - e<sub>b</sub> d - z u).
     */
    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (int i = 0, x = 0; i < particles.count(); i++, x += STRIDE) {
            Vector3 place = Vector3.at(state, x);
            Vector3 v = Vector3.at(state, x + 3);
            Vector3 d = place.minus(centre);
            double z = axis.dot(d);
            for (int b = 0; b < 3; b++) {
                Vector3 unit = new Vector3(b == 0 ? 1 : 0, b == 1 ? 1 : 0, b == 2 ? 1 : 0);
                Vector3 change = axis.times(5 * z * axis.dot(unit) - d.dot(unit)).minus(d.times(axis.dot(unit)))
                        .minus(unit.times(z)).times(strength * curvature);
                putColumn(dFdX, b, v.cross(change).times(charge));
                putColumn(dFdV, b, unit.cross(field(place)).times(charge));
            }
            derivatives.add(i, i, dFdX, dFdV);
        }
    }

    private static void putColumn(double[] matrix, int column, Vector3 values) {
        matrix[column] = values.x();
        matrix[3 + column] = values.y();
        matrix[6 + column] = values.z();
    }

    /** A magnetic field in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Vector3> FIELD = VectorType.notZero("T").required("field",
                "B0, the field at the centre (T).");
        private static final Key<Double> CHARGE = NumberType.any("C").withDefault("charge", 1.0,
                "q, the charge of every particle (C).");
        private static final Key<Vector3> CENTRE = VectorType.of("m").withDefault("centre", Vector3.ZERO,
                "The centre of a magnetic bottle (m).");
        private static final Key<Double> LENGTH = NumberType.positive("m").optional("bottle",
                "L (m): along its axis the field is B0 (1 + z^2/L^2), so that particles are caught; by default it is"
                + " the same everywhere.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("magneticField", "Turns moving charges: F = q v x B.", FIELD, CHARGE, CENTRE, LENGTH);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new MagneticField(scene.particles(), values.get(CHARGE), values.get(FIELD), values.get(CENTRE),
                    values.find(LENGTH).orElse(Double.POSITIVE_INFINITY)));
        }
    }
}
