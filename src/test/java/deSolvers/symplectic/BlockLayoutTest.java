package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Kicks and drifts of blocks of d positions and d velocities: written out for some d, and the same for all. */
class BlockLayoutTest {
    private static final double H = 0.25;
    private static final double DRIFT = -0.5;
    private static final int BLOCKS = 3;

    private final Random random = new Random(14);

    private double[] random(int d) {
        return random.doubles(2L * d * BLOCKS, -1, 1).toArray();
    }

    private static boolean isVelocity(int entry, int d) {
        return entry % (2 * d) >= d;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void aKickChangesVelocitiesOnly(int d) {
        double[] state = random(d);
        double[] dSdt = random(d);
        double[] kicked = state.clone();
        BlockLayout.kick(kicked, dSdt, state.length, d, H);
        for (int e = 0; e < state.length; e++) {
            assertEquals(isVelocity(e, d) ? state[e] + H * dSdt[e] : state[e], kicked[e], "entry " + e);
        }
    }

    /** The drift is with the velocity after the kick; the result may be another array, which is all written, or the same one. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void aDriftFollowsWithTheNewVelocity(int d) {
        double[] state = random(d);
        double[] dSdt = random(d);
        double[] result = random(d);
        double[] before = state.clone();
        BlockLayout.kickDrift(state, dSdt, state.length, d, H, DRIFT, result);
        assertArrayEquals(before, state);
        for (int e = 0; e < state.length; e++) {
            int v = isVelocity(e, d) ? e : e + d;
            double velocity = state[v] + H * dSdt[v];
            assertEquals(isVelocity(e, d) ? velocity : state[e] + DRIFT * velocity, result[e], "entry " + e);
        }
        BlockLayout.kickDrift(state, dSdt, state.length, d, H, DRIFT, state);
        assertArrayEquals(result, state);
    }

    /** The derivative's position entries are the velocities again: read there they give the same, and have to be numbers. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void velocitiesMayBeReadInTheDerivative(int d) {
        double[] state = random(d);
        double[] dSdt = random(d);
        for (int e = 0; e < dSdt.length; e++) {
            dSdt[e] = isVelocity(e, d) ? dSdt[e] : state[e + d];
        }
        double[] expected = random(d);
        BlockLayout.kickDrift(state, dSdt, state.length, d, H, DRIFT, expected);
        double[] result = random(d);
        BlockLayout.kickDriftFromDerivative(state, dSdt, state.length, d, H, DRIFT, result);
        assertArrayEquals(expected, result);
        for (int e = 0; e < dSdt.length; e++) {
            double[] wrong = dSdt.clone();
            wrong[e] = Double.NaN;
            BlockLayout.kickDriftFromDerivative(state, wrong, state.length, d, H, DRIFT, result);
            assertTrue(Double.isNaN(result[isVelocity(e, d) ? e - d : e]), "entry " + e);
        }
    }
}
