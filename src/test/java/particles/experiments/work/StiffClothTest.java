package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.implicit.LinearisedEulerSolver;
import deSolvers.linear.SolverWork;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Counts behind the table, which do not depend on the machine. */
@Tag("slow")
class StiffClothTest {
    private static final double SPRINGS = 23_938;
    /**
     * Steps that rk4 needs, from 5 to 5,000: conjugate gradients are used up to 20, where they need most iterations,
     * and elimination from 30 on.
     */
    private static final long[] SWEEP = {5, 10, 20, 30, 100, 1000, 5000};

    private static SolverWork linearisedWork(double stiffness) {
        LinearisedEulerSolver solver = new LinearisedEulerSolver();
        solver.stepState(StiffCloth.cloth(stiffness), StiffCloth.FRAME);
        return solver.getWork();
    }

    @Test
    void theFastestVibrationGrowsWithTheRootOfTheStiffness() {
        double stiffness = StiffCloth.stiffnessFor(5000);
        assertEquals(4999.99, StiffCloth.FRAME * StiffCloth.fastest(stiffness) / StiffCloth.RK4_LIMIT, 0.001);
    }

    @Test
    void theCostOfALinearisedStepHardlyDependsOnStiffness() {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (long steps : SWEEP) {
            double stiffness = StiffCloth.stiffnessFor(steps);
            SolverWork work = linearisedWork(stiffness);
            assertEquals(steps < 30 ? 0 : 1, work.factorisations);
            least = Math.min(least, work.blockOperations);
            most = Math.max(most, work.blockOperations);
        }
        // Measured 2.58e6 products of 3 x 3 blocks at 5, 7.63e6 at 20, and 9.91e6 with elimination, at each of the
        // others: 3.84 times as many. For softer cloths the steps are cheaper still: 1.23e6 at 2.
        assertTrue(most < 4 * least, least + " to " + most + " products of blocks");
    }

    @Test
    void implicitStepsAreCheaperForStiffClothAndRk4ForSoftCloth() {
        double stiff = linearisedWork(StiffCloth.stiffnessFor(5000)).blockOperations;
        // A product costs no more than a spring's force. Measured 60 times as many forces at 5,000 steps of RK4 ...
        assertTrue(4 * 5000 * SPRINGS > 25 * stiff, stiff + " products of blocks");
        double soft = linearisedWork(StiffCloth.stiffnessFor(5)).blockOperations;
        assertTrue(4 * 5 * SPRINGS < soft / 4, soft + " products of blocks");       // ... and a thirteenth at 5
    }
}
