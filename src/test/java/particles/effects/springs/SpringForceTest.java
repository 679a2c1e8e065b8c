package particles.effects.springs;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Systems;

/** A spring's force at lengths where squares overflow, underflow or vanish, and refused parameters. */
class SpringForceTest {
    private final SpringForce springs = new SpringForce(Systems.row(2).getParticles());

    private double[] force(double... state) {
        double[] force = new double[12];
        springs.addForces(state, 0, force);
        return force;
    }

    /** r = (3, 4, 0) length: |r| = 5 length, damped along (0.6, 0.8, 0). {@link SpringKernelTest} has the forces. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-200, 1e-141, 1e-139, 1e-20, 1, 1e20, 1e138, 1e141, 1e200, 1e300})
    void lengthAndDissipatedPowerAreRightAtAllLengths(double length) {
        springs.addSpring(0, 1, 2, 2 * length, 0.5);
        assertEquals(5 * length, springs.length(new double[] {0, 0, 0, 0, 0, 0, 3 * length, 4 * length, 0, 0, 0, 0}, 0),
                1e-15 * 5 * length);
        double[] apart = {0, 0, 0, 0, 0, 0, 3 * length, 4 * length, 0, 3, 2, 5};
        assertEquals(0.5 * 3.4 * 3.4, springs.getDissipatedPower(apart, 0), 1e-14, "they part with 0.6 * 3 + 0.8 * 2");
        double[] across = {0, 0, 0, 0, 0, 0, 0, 4 * length, 3 * length, 7, 1, 2};
        assertEquals(0.5 * 2 * 2, springs.getDissipatedPower(across, 0), 1e-14, "0.8 * 1 + 0.6 * 2");
    }

    @Test
    void coincidentParticlesFeelNoForce() {
        springs.addSpring(0, 1, 100, 1, 3);
        double[] state = new double[12];
        state[3] = 1;
        assertArrayEquals(new double[12], force(state));
        assertEquals(50, springs.getPotentialEnergy(state, 0), "the energy of a spring compressed to a point");
        assertEquals(0, springs.getDissipatedPower(state, 0));
    }

    @Test
    void impossibleSpringsAreRefused() {
        Steps.assertFails(IllegalArgumentException.class, "'p1' to itself", () -> springs.addSpring(1, 1, 1, 1, 0));
        for (int[] ends : new int[][] {{0, 2}, {2, 0}, {-1, 0}, {0, -1}}) {
            Steps.assertFails(IllegalArgumentException.class, "there are 2",
                    () -> springs.addSpring(ends[0], ends[1], 1, 1, 0));
        }
        Steps.assertRefused(() -> springs.addSpring(0, 1, -1, 1, 0), () -> springs.addSpring(0, 1, 1, Double.NaN, 0),
                () -> springs.addSpring(0, 1, 1, 1, Double.POSITIVE_INFINITY));
        assertEquals(0, springs.springCount());
    }
}
