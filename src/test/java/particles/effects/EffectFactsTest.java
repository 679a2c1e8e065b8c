package particles.effects;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.Systems;
import particles.effects.springs.SpringForce;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.law.PerParticleEffect;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;

/** The interfaces and flags of each law, and the limits of its parameters. */
class EffectFactsTest {
    private static final double MAX = Double.MAX_VALUE;
    private static final double TINY = Double.MIN_VALUE;
    private static final double NAN = Double.NaN;
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    private static final Plane GROUND = Plane.ground(0);
    private static final Sphere BALL = new Sphere(Vector3.ZERO, 1, false);

    private final Particles particles = new ParticleSystem().getParticles();

    private static void assertFacts(Effect effect, String name, boolean perParticle, boolean byVelocity, Trait trait) {
        assertEquals(name, effect.getName());
        assertEquals(perParticle, effect instanceof PerParticleEffect, name + " acts on each particle by itself");
        assertEquals(byVelocity, effect.dependsOnVelocity(), name + " depends on velocity");
        assertTrue(effect instanceof DifferentiableEffect, name + " knows its derivatives");
        assertTrue(effect.getTraits().contains(trait), name + " is " + effect.getTraits());
    }

    @Test
    void eachLawDeclaresItsInterfacesAndFlags() {
        assertFacts(new Gravity(particles, Vector3.ZERO), "gravity", true, false, Trait.CONSERVATIVE);
        assertFacts(new PointAttraction(particles, Vector3.ZERO, 1, 0), "attraction", true, false, Trait.CONSERVATIVE);
        assertFacts(AirDrag.linear(particles, 1, Wind.STILL), "drag", true, true, Trait.DISSIPATIVE);
        assertFacts(AirDrag.quadratic(particles, 1, Wind.STILL), "quadraticDrag", true, true, Trait.DISSIPATIVE);
        for (double damping : new double[] {0, TINY, 1}) {
            Trait trait = damping > 0 ? Trait.DISSIPATIVE : Trait.CONSERVATIVE;
            assertFacts(new Penalty(particles, GROUND, 1, damping), "penaltyPlane", true, damping > 0, trait);
            assertFacts(new Penalty(particles, BALL, 1, damping), "penaltySphere", true, damping > 0, trait);
            assertFacts(new Cohesion(particles, 1, 0.5, 1, damping), "cohesion", false, damping > 0, trait);
            assertFacts(new Repulsion(particles, 1, true, 1, damping), "repulsion", false, damping > 0, trait);
            assertFacts(twoSprings(damping), "springs", false, damping > 0, trait);
        }
        assertEquals(0.25, AirDrag.linear(particles, 0.25, Wind.STILL).getSlowCoefficient());
    }

    /** Two springs, only the second damped: one is enough to depend on velocity. */
    private static SpringForce twoSprings(double damping) {
        SpringForce springs = new SpringForce(Systems.row(2).getParticles());
        springs.addSpring(0, 1, 1, 1, damping);
        springs.addSpring(1, 0, 1, 1, 0);
        return springs;
    }

    /** u = mean + gust sin(2 pi t / period). */
    @Test
    void gustsVaryAsASineInTime() {
        GustyWind wind = new GustyWind(new Vector3(1, 2, 3), new Vector3(0.5, 0.25, -1), 4);
        double[][] expected = {{0, 1, 2, 3}, {1, 1.5, 2.25, 2}, {3, 0.5, 1.75, 4}, {1.0 / 3, 1.25, 2.125, 2.5}};
        for (double[] row : expected) {
            double[] air = new double[18];
            wind.getVelocities(new double[18], row[0], air, 1, 2);
            double[] second = new double[18];
            System.arraycopy(row, 1, second, 9, 3);
            assertArrayEquals(second, air, 1e-15);      // measured 1.1e-16
            Vector3 told = wind.velocityAt(row[0]);
            assertArrayEquals(Arrays.copyOfRange(air, 9, 12), new double[] {told.x(), told.y(), told.z()});
        }
    }

    @SuppressWarnings("ReturnValueIgnored")
    private static void assertRange(String what, DoubleFunction<Object> maker, double[] allowed, double[] refused) {
        for (double value : allowed) {
            maker.apply(value);
        }
        for (double value : refused) {
            assertThrows(IllegalArgumentException.class, () -> maker.apply(value), what + " of " + value);
        }
    }

    private static final double[] ZERO_OR_MORE = {0, -0.0, TINY, 1, MAX};
    private static final double[] LESS = {-TINY, -1, NAN, INFINITE, -INFINITE};
    private static final double[] MORE_THAN_ZERO = {TINY, 1, MAX};
    private static final double[] ZERO_OR_LESS = {0, -0.0, -TINY, -1, NAN, INFINITE, -INFINITE};

    @Test
    void parametersAreAcceptedUpToTheirLimits() {
        assertRange("drag", c -> AirDrag.linear(particles, c, Wind.STILL), ZERO_OR_MORE, LESS);
        assertRange("quadratic drag", c -> AirDrag.quadratic(particles, c, Wind.STILL), ZERO_OR_MORE, LESS);
        assertRange("softening", s -> new PointAttraction(particles, Vector3.ZERO, 1, s), ZERO_OR_MORE, LESS);
        assertRange("strength", mu -> new PointAttraction(particles, Vector3.ZERO, mu, 0), new double[] {-MAX, 0, MAX},
                new double[] {NAN, INFINITE, -INFINITE});
        assertRange("stiffness", k -> new Penalty(particles, GROUND, k, 0), ZERO_OR_MORE, LESS);
        assertRange("loss", b -> new Penalty(particles, BALL, 1, b), ZERO_OR_MORE, LESS);
        assertRange("depth", e -> new Cohesion(particles, 1, 0.5, e, 0), MORE_THAN_ZERO, ZERO_OR_LESS);
        assertRange("damping", b -> new Cohesion(particles, 1, 0.5, 1, b), ZERO_OR_MORE, LESS);
        assertRange("distance", d -> new Cohesion(particles, 1, d, 1, 0), new double[] {TINY, 0.5, Math.nextDown(1.0)},
                new double[] {0, -1, 1, 2, NAN});
        assertRange("range", h -> new Cohesion(particles, h, 0.5, 1, 0), new double[] {Math.nextUp(0.5), MAX},
                new double[] {0.5, 0, NAN, INFINITE});
        assertRange("stiffness", k -> new Repulsion(particles, 1, true, k, 0), MORE_THAN_ZERO, ZERO_OR_LESS);
        assertRange("damping", c -> new Repulsion(particles, 1, true, 1, c), ZERO_OR_MORE, LESS);
        assertRange("radius", r -> new Repulsion(particles, r, false, 1, 0), MORE_THAN_ZERO, ZERO_OR_LESS);
        assertRange("radius", r -> {
            Repulsion repulsion = new Repulsion(particles, 1, false, 1, 0);
            repulsion.setRadius(0, r);
            return repulsion;
        }, MORE_THAN_ZERO, ZERO_OR_LESS);
        assertRange("period", t -> new GustyWind(Vector3.ZERO, Vector3.ZERO, t), MORE_THAN_ZERO, ZERO_OR_LESS);
        assertRange("turbulence", s -> new TurbulentWind(Vector3.ZERO, s, 1, 1), ZERO_OR_MORE, LESS);
        assertRange("eddies", l -> new TurbulentWind(Vector3.ZERO, 1, l, 1), MORE_THAN_ZERO, ZERO_OR_LESS);
        assertRange("a spring's damping", EffectFactsTest::twoSprings, ZERO_OR_MORE, LESS);
        Vector3 nowhere = new Vector3(0, NAN, 0);
        Steps.assertRefused(() -> new Gravity(particles, nowhere),
                () -> new PointAttraction(particles, nowhere, 1, 0), () -> new GustyWind(nowhere, Vector3.ZERO, 1),
                () -> new GustyWind(Vector3.ZERO, nowhere, 1), () -> new TurbulentWind(nowhere, 1, 1, 1));
    }

    /** At a surface, at the end of a range and at a centre the force is 0, not NaN. */
    @Test
    void forceIsZeroAtSurfacesRangesAndCentres() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, Vector3.ZERO, new Vector3(0, -1, 0), false);
        system.addParticle("b", 1, new Vector3(1, 0, 0), new Vector3(1, 0, 0), false);
        Particles both = system.getParticles();
        double[] state = system.getOwnState();
        for (Effect effect : List.of(new Penalty(both, GROUND, 7, 0.5), new Cohesion(both, 1, 0.5, 7, 0.5),
                new Penalty(both, BALL, 7, 0.5))) {
            double[] force = new double[12];
            effect.addForces(state, 0, force);
            assertArrayEquals(new double[12], force, effect.getName());
        }
        // At a ball's centre the depth is largest, but no direction leads out faster than another.
        assertEquals(3.5, new Penalty(both, BALL, 7, 0.5).getPotentialEnergy(state, 0));
        assertEquals(0, new Penalty(both, GROUND, 7, 0.5).getPotentialEnergy(state, 0));
        assertEquals(0, new Cohesion(both, 1, 0.5, 7, 0.5).getPotentialEnergy(state, 0));
    }
}
