package particles.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import deSolvers.ForceDerivatives;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.teaching.effects.EffectCheck;
import particles.teaching.effects.EffectClaims;
import particles.teaching.effects.EffectClaims.Broken;
import particles.teaching.effects.EffectClaims.Claim;
import particles.teaching.effects.EffectSample;

/** Every effect has the properties that it claims, and planted errors are found. */
class EffectClaimsTest {
    private static final GustyWind WIND = new GustyWind(new Vector3(2, 0, 1), new Vector3(1, 0.5, 0), 1.7);

    private static final TurbulentWind TURBULENCE = new TurbulentWind(new Vector3(2, 0, 1), 1.5, 2, 42);

    private static SpringForce springs(Particles particles, double damping) {
        SpringForce springs = new SpringForce(particles);
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < i; j++) {
                springs.addSpring(i, j, 10 + i + 2 * j, 0.7 + 0.1 * i, damping * (1 + j));
            }
        }
        return springs;
    }

    private static Muscles muscles(Particles particles, double rise) {
        Muscles muscles = new Muscles(springs(particles, 0.8), 1.3, rise);
        for (int s = 0; s < 15; s += 2) {
            muscles.add(s, 0.3 + 0.02 * s, 0.1 * s);
        }
        return muscles;
    }

    private static List<Claim> kinds(List<Broken> broken) {
        return broken.stream().map(Broken::claim).distinct().toList();
    }

    /** An effect with one kind of error fails exactly the check for that kind. */
    @Test
    void onlyTheDerivativeCheckFindsAWrongDerivative() {
        assertEquals(List.of(Claim.DERIVATIVE), kinds(broken(p -> new WrongDerivative(springs(p, 0.8),
                springs(p, 0.8 * (1 + 1e-3))))));
    }

    private static List<Broken> broken(Function<Particles, Effect> maker) {
        ParticleSystem system = EffectSample.system();
        return EffectClaims.broken(system, maker.apply(system.getParticles()), 2003);
    }

    private static Stream<Arguments> laws() {
        Vector3 at = new Vector3(1, 0.3, 0.8);
        Map<String, Function<Particles, Effect>> laws = new TreeMap<>(Map.of(
                "gravity", p -> new Gravity(p, new Vector3(0.3, -9.81, 0.1)),
                "attraction", p -> new PointAttraction(p, new Vector3(0.5, -2, 0.4), 3, 0),
                "gravitation", p -> new Gravitation(p, 3, 0),
                "softened gravitation", p -> new Gravitation(p, 3, 0.4),
                "softened", p -> new PointAttraction(p, new Vector3(1, 0, 1), 3, 0.3)));
        Map.of("still air", Wind.STILL, "gusts", WIND, "turbulence", TURBULENCE).forEach((air, wind) -> {
            laws.put("drag in " + air, p -> AirDrag.linear(p, 0.4, wind));
            laws.put("quadratic drag in " + air, p -> AirDrag.quadratic(p, 0.4, wind));
        });
        laws.put("muscles", p -> muscles(p, 0));
        laws.put("muscles whose amplitude rises", p -> muscles(p, 3));
        // with a plane through the middle of the particles, some are inside it in every state
        for (double c : new double[] {0, 0.8, 5}) {
            laws.put("springs " + c, p -> springs(p, c));
            laws.put("cohesion " + c, p -> new Cohesion(p, 1.9, 1.1, 2, c));
            laws.put("repulsion " + c, p -> new Repulsion(p, 0.9, false, 20, c));
            laws.put("hertz " + c, p -> {
                Repulsion hertz = new Repulsion(p, 0.6, true, 20, c);
                hertz.setRadius(2, 1.5);
                return hertz;
            });
            laws.put("plane " + c, p -> new Penalty(p, new Plane(new Vector3(1, 0.5, 1), new Vector3(1, 2, -1)),
                    30, c));
            laws.put("ball " + c, p -> new Penalty(p, new Sphere(at, 1.2, false), 30, c));
            laws.put("hollow " + c, p -> new Penalty(p, new Sphere(at, 0.8, true), 30, c));
        }
        return laws.entrySet().stream().map(law -> Arguments.of(law.getKey(), law.getValue()));
    }

    /** A law keeps its claims; with the forces on all particles but the first times 1.01 or -1 it does not. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("laws")
    void everyLawKeepsItsClaims(String name, Function<Particles, Effect> law) {
        assertEquals(List.of(), broken(law));
        assertEquals(List.of(), EffectCheck.check(law), "the check of students' laws accuses none");
        assertFalse(broken(p -> new Altered(law.apply(p), 1, 1.01)).isEmpty(), "a percent too much for others");
        assertFalse(broken(p -> new Altered(law.apply(p), 1, -1)).isEmpty(), "the opposite on others");
    }

    private static MagneticField bottle(Particles particles, double length) {
        return new MagneticField(particles, 2, new Vector3(1, 2, -1), new Vector3(1, 0.3, 0.8), length);
    }

    /** It stores and takes no energy, so its derivatives are all that it claims. */
    @Test
    void theDerivativesOfAMagneticBottleAreThoseOfItsForces() {
        assertEquals(List.of(), broken(p -> bottle(p, 1.5)));
        assertEquals(List.of(Claim.DERIVATIVE),
                kinds(broken(p -> new WrongDerivative(bottle(p, 1.5), bottle(p, 1.501)))));
    }

    @Test
    void aMissingPartnersForceIsFound() {
        assertFalse(broken(p -> new Altered(springs(p, 0), 0, 1)).isEmpty());
    }

    /** Wind drives particles, and its drag takes energy out of them. */
    @ParameterizedTest
    @CsvSource({"DISSIPATIVE, DRIVEN_POWER", "DRIVING, DISSIPATED_POWER"})
    void eachPowerNeedsItsClaim(Trait claimed, Claim missed) {
        assertEquals(List.of(missed), kinds(broken(p -> new Altered(AirDrag.linear(p, 0.4, WIND), 1, 1) {
            @Override
            public Set<Trait> getTraits() {
                return Set.of(claimed);
            }
        })));
    }

    /** An effect with the force derivatives of another one. */
    private static final class WrongDerivative extends Altered implements DifferentiableEffect {
        private final DifferentiableEffect other;

        WrongDerivative(Effect effect, DifferentiableEffect other) {
            super(effect, 1, 1);
            this.other = other;
        }

        @Override
        public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
            other.addForceDerivatives(state, time, derivatives);
        }
    }

    /** An effect with its forces multiplied: on the first particle by one factor, on the others by another. */
    private static class Altered implements Effect {
        private final Effect effect;
        private final double first;
        private final double others;

        Altered(Effect effect, double first, double others) {
            this.effect = effect;
            this.first = first;
            this.others = others;
        }

        @Override
        public String getName() {
            return effect.getName();
        }

        @Override
        public Set<Trait> getTraits() {
            return effect.getTraits();
        }

        @Override
        public boolean dependsOnVelocity() {
            return effect.dependsOnVelocity();
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            double[] right = new double[force.length];
            effect.addForces(state, time, right);
            for (int k = 0; k < force.length; k++) {
                force[k] += right[k] * (k < 6 ? first : others);
            }
        }

        @Override
        public double getPotentialEnergy(double[] state, double time) {
            return effect.getPotentialEnergy(state, time);
        }

        @Override
        public double getDissipatedPower(double[] state, double time) {
            return effect.getDissipatedPower(state, time);
        }

        @Override
        public double getDrivenPower(double[] state, double time) {
            return effect.getDrivenPower(state, time);
        }
    }
}
