package particles.effects;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.ForceDerivatives;
import java.util.Arrays;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;

/** An effect depends only on the state it is given, not on earlier calls. */
class EffectStatesTest {
    private static final int COUNT = 5;
    private static final Wind WIND = new TurbulentWind(new Vector3(1, 0.2, -0.5), 0.7, 1.3, 4);

    private final Random random = new Random(23);

    static Stream<Function<Particles, Effect>> effects() {
        return Stream.of(p -> new Gravity(p, new Vector3(0.3, -9.81, 0.1)),
                p -> new PointAttraction(p, new Vector3(0.5, -2, 0.4), 3, 0.3),
                p -> new LinearDrag(p, 0.4, Wind.STILL),
                p -> new LinearDrag(p, 0.4, WIND),
                p -> new QuadraticDrag(p, 0.4, WIND),
                p -> new Penalty(p, Plane.ground(0.5), 30, 0.8),
                p -> new Penalty(p, new Sphere(new Vector3(0.5, 0.5, 0.5), 1.2, false), 30, 0.8),
                p -> new Cohesion(p, 1.5, 0.8, 2, 0.8),
                p -> new Repulsion(p, 0.4, false, 2, 0.8),
                EffectStatesTest::springs);
    }

    private static Effect springs(Particles particles) {
        SpringForce springs = new SpringForce(particles);
        springs.addSpring(3, 1, 10, 0.7, 0.8);
        springs.addSpring(4, 0, 20, 0.5, 0.2);
        return springs;
    }

    private double[] state() {
        return random.doubles(6 * COUNT, 0, 1).toArray();
    }

    /** Everything an effect computes from a state: force, energy, powers and derivatives. */
    private static double[] all(Effect effect, double[] state) {
        double[] force = new double[6 * COUNT];
        effect.addForces(state, 0.3, force);
        Sum sum = new Sum();
        ((DifferentiableEffect) effect).addForceDerivatives(state, 0.3, sum);
        double[] all = {effect.getPotentialEnergy(state, 0.3), effect.getDissipatedPower(state, 0.3),
            effect.getDrivenPower(state, 0.3)};
        return Stream.of(force, all, sum.values).flatMapToDouble(Arrays::stream).toArray();
    }

    /** Adds blocks up with weights that tell particles, entries, places and velocities apart. */
    private static final class Sum implements ForceDerivatives {
        final double[] values = new double[COUNT * COUNT];

        @Override
        public void add(int i, int j, double[] dFdX, double[] dFdV) {
            for (int e = 0; e < 9; e++) {
                values[COUNT * i + j] += (e + 1) * dFdX[e] + (e + 1.5) * dFdV[e];
            }
        }

        @Override
        public void addPair(int i, int j, double[] dFdX, double[] dFdV) {
            add(i, j, dFdX, dFdV);
        }

        @Override
        public void transformRow(int i, double[] matrix) {
            throw new AssertionError("only reactions transform rows");
        }
    }

    @ParameterizedTest
    @MethodSource("effects")
    void resultsDoNotDependOnEarlierCalls(Function<Particles, Effect> maker) {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < COUNT; i++) {
            system.addParticle("p" + i, 1 + i, Vector3.ZERO, Vector3.ZERO, i == 2);
        }
        Effect used = maker.apply(system.getParticles());
        for (int round = 0; round < 20; round++) {
            double[] state = state();
            double[] expected = all(maker.apply(system.getParticles()), state);
            Sum derivatives = new Sum();
            ((DifferentiableEffect) used).addForceDerivatives(state, 0.3, derivatives);
            for (int e = 0; e < COUNT * COUNT; e++) {
                assertEquals(expected[6 * COUNT + 3 + e], derivatives.values[e], 1e-12, "asked for first: block " + e);
            }
            assertArrayEquals(expected, all(used, state), 1e-12, used.getName());   // sorted springs add up otherwise
            used.addForces(state(), 0.3, new double[6 * COUNT]);
            assertEquals(expected[6 * COUNT], used.getPotentialEnergy(state, 0.3), 1e-12);
            used.addForces(state(), 0.3, new double[6 * COUNT]);
            assertEquals(expected[6 * COUNT + 1], used.getDissipatedPower(state, 0.3), 1e-12);
        }
    }
}
