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
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Vector3;

/** An effect depends only on the state it is given, not on earlier calls. */
class EffectStatesTest {
    private static final int COUNT = 6;
    private final Random random = new Random(23);

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

    @ParameterizedTest(name = "{0}")
    @MethodSource("particles.effects.EffectClaimsTest#laws")
    void resultsDoNotDependOnEarlierCalls(String name, Function<Particles, Effect> maker) {
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
            assertArrayEquals(expected, all(used, state), 1e-12, name);   // sorted springs add up otherwise
            used.addForces(state(), 0.3, new double[6 * COUNT]);
            assertEquals(expected[6 * COUNT], used.getPotentialEnergy(state, 0.3), 1e-12);
            used.addForces(state(), 0.3, new double[6 * COUNT]);
            assertEquals(expected[6 * COUNT + 1], used.getDissipatedPower(state, 0.3), 1e-12);
        }
    }
}
