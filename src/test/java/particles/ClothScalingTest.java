package particles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.implicit.BackwardEulerSolver;
import deSolvers.implicit.ImplicitWork;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.effects.SpringForce;

/**
 * What an implicit step of a cloth costs, from 1,000 to 250,000 springs with the same omega deltaT of about 6 (k = 100 N/m,
 * m = 10 g, deltaT = 1/60 s). The work is counted in products of 3 x 3 blocks, which does not depend on the machine.
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
            assertEquals(0, work.factorisations(), "conjugate gradients throughout");
            cost[i] = work.blockOperations();
        }
        assertTrue(springs[0] < 1100 && springs[4] > 250_000);
        double exponent = StrictMath.log(cost[4] / cost[0]) / StrictMath.log(springs[4] / springs[0]);
        // Measured 0.986: 2.44e6 products for 3 steps of 1,038 springs, 5.49e8 for 252,558; 939 and 884 iterations in all.
        assertTrue(exponent < 1.1, "exponent " + exponent);         // the promise is 1.2
    }
}
