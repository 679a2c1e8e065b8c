package particles.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import deSolvers.ForceDerivatives;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.teaching.effects.EffectClaims;
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

    private static List<String> kinds(List<String> broken) {
        return broken.stream().map(line -> line.substring(0, line.indexOf(' '))).distinct().sorted().toList();
    }

    /** An effect with one kind of error fails exactly the check for that kind. */
    @Test
    void onlyTheDerivativeCheckFindsAWrongDerivative() {
        assertEquals(List.of("derivative:"), kinds(broken(p -> new WrongDerivative(springs(p, 0.8)) {
            @Override
            public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
                springs(p, 0.8 * (1 + 1e-3)).addForceDerivatives(state, time, derivatives);
            }
        })));
    }

    private static List<String> broken(Function<Particles, Effect> maker) {
        ParticleSystem system = EffectSample.system();
        return EffectClaims.broken(system, maker.apply(system.getParticles()), 2003);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.8})
    void springsKeepTheirClaims(double damping) {
        assertEquals(List.of(), broken(p -> springs(p, damping)));
    }

    @Test
    void gravityKeepsItsClaims() {
        assertEquals(List.of(), broken(p -> new Gravity(p, new Vector3(0.3, -9.81, 0.1))));
    }

    @Test
    void dragKeepsItsClaimsInStillAirAndInWind() {
        assertEquals(List.of(), broken(p -> new LinearDrag(p, 0.4, Wind.STILL)));
        assertEquals(List.of(), broken(p -> new LinearDrag(p, 0.4, WIND)));
    }

    @Test
    void quadraticDragKeepsItsClaimsInStillAirAndInWind() {
        assertEquals(List.of(), broken(p -> new QuadraticDrag(p, 0.4, Wind.STILL)));
        assertEquals(List.of(), broken(p -> new QuadraticDrag(p, 0.4, WIND)));
    }

    @Test
    void bothDragsKeepTheirClaimsInTurbulence() {
        assertEquals(List.of(), broken(p -> new LinearDrag(p, 0.4, TURBULENCE)));
        assertEquals(List.of(), broken(p -> new QuadraticDrag(p, 0.4, TURBULENCE)));
    }

    @Test
    void attractionKeepsItsClaims() {
        assertEquals(List.of(), broken(p -> new PointAttraction(p, new Vector3(0.5, -2, 0.4), 3, 0)));
        assertEquals(List.of(), broken(p -> new PointAttraction(p, new Vector3(1, 0, 1), 3, 0.3)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.8})
    void cohesionKeepsItsClaims(double damping) {
        assertEquals(List.of(), broken(p -> new Cohesion(p, 1.9, 1.1, 2, damping)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.8})
    void repulsionKeepsItsClaims(double damping) {
        assertEquals(List.of(), broken(p -> new Repulsion(p, 0.9, false, 20, damping)));
        assertEquals(List.of(), broken(p -> {
            Repulsion hertz = new Repulsion(p, 0.6, true, 20, damping);
            hertz.setRadius(2, 1.5);
            return hertz;
        }));
    }

    /** With a plane through the middle of the particles, some are inside it in every state. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.8, 5})
    void penaltiesKeepTheirClaims(double loss) {
        assertEquals(List.of(),
                broken(p -> new PenaltyPlane(p, new Plane(new Vector3(1, 0.5, 1), new Vector3(1, 2, -1)), 30, loss)));
        assertEquals(List.of(), broken(p -> new PenaltySphere(p, new Sphere(new Vector3(1, 0.3, 0.8), 1.2, false), 30,
                loss)));
        assertEquals(List.of(), broken(p -> new PenaltySphere(p, new Sphere(new Vector3(1, 0.3, 0.8), 0.8, true), 30,
                loss)));
    }

    @Test
    void plantedErrorsAreFound() {
        assertFalse(broken(p -> new Altered(springs(p, 0), 1, -1)).isEmpty(), "springs that push when stretched");
        assertFalse(broken(p -> new Altered(springs(p, 0.8), 1, 0.5)).isEmpty(), "half of the force");
        assertFalse(broken(p -> new Altered(new Gravity(p, new Vector3(0, -9.81, 0)), 1, -1)).isEmpty(),
                "gravity upwards");
        assertFalse(broken(p -> new Altered(new LinearDrag(p, 0.4, Wind.STILL), 1, -1)).isEmpty(), "drag that drives");
        assertFalse(broken(p -> new Altered(new LinearDrag(p, 0.4, WIND), 1, 1.01)).isEmpty(),
                "a percent too much drag");
        assertFalse(broken(p -> new Altered(springs(p, 0), 0, 1)).isEmpty(), "no force on the partner");
        assertFalse(broken(p -> new Altered(new PointAttraction(p, Vector3.ZERO, 3, 0.5), 1, -1)).isEmpty(),
                "repulsion");
        assertFalse(broken(p -> new Altered(new Cohesion(p, 1.9, 1.1, 2, 0.5), 1, 1.01)).isEmpty(),
                "a percent on one side");
        assertFalse(broken(p -> new Altered(new QuadraticDrag(p, 0.4, TURBULENCE), 1, 1.01)).isEmpty(),
                "a percent too much");
        assertFalse(broken(p -> new Altered(new PenaltyPlane(p, Plane.ground(0.5), 30, 0.8), 1, -1)).isEmpty(),
                "a plane that pulls inwards");
    }

    /** An effect with wrong force derivatives and otherwise unchanged. */
    private abstract static class WrongDerivative extends Altered implements DifferentiableEffect {
        WrongDerivative(Effect effect) {
            super(effect, 1, 1);
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
            if (first == 1 && others == 1) {
                effect.addForces(state, time, force);
                return;
            }
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
