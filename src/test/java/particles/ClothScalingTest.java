package particles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.implicit.BackwardEulerSolver;
import deSolvers.linear.ImplicitWork;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.effects.springs.SpringForce;

/**
 * The cost of an implicit step of a cloth, from 1,000 to 250,000 springs with the same omega deltaT of about 6 (k = 100
 * N/m, m = 10 g, deltaT = 1/60 s), counted in products of 3 x 3 blocks, which do not depend on the machine.
 */
@Tag("slow")
class ClothScalingTest {

    @Test
    void theCostGrowsNoFasterThanSpringsToThePower1Point2() {
        double[] springs = new double[5];
        double[] cost = new double[5];
        int[] edges = {14, 28, 52, 103, 206};
        for (int i = 0; i < edges.length; i++) {
            ParticleSystem system = Cloth.hanging(edges[i], 100, 0);
            springs[i] = ((SpringForce) system.getEffects().get(1)).springCount();
            BackwardEulerSolver solver = new BackwardEulerSolver();
            for (int step = 0; step < 3; step++) {
                solver.stepState(system, 1.0 / 60);
            }
            ImplicitWork work = solver.getWork();
            assertEquals(i == 0, work.factorisations() > 0, "elimination where that takes less work than iterations");
            assertEquals(i > 0, work.krylovIterations() > 0);
            cost[i] = work.blockOperations();
        }
        assertTrue(springs[0] < 1100 && springs[4] > 250_000);
        // Measured 1.105 and, without the smallest, 1.003: 1.27e6 products for 3 steps of 1,038 springs, half of what
        // conjugate
        // gradients would take, 9.50e6 in 868 iterations for 4,426, and 5.49e8 in 884 iterations for 252,558.
        assertTrue(exponent(springs, cost, 0) < 1.2, "exponent " + exponent(springs, cost, 0));     // what is promised
        assertTrue(exponent(springs, cost, 1) < 1.1, "exponent " + exponent(springs, cost, 1));
    }

    private static double exponent(double[] springs, double[] cost, int from) {
        int last = springs.length - 1;
        return StrictMath.log(cost[last] / cost[from]) / StrictMath.log(springs[last] / springs[from]);
    }
}
