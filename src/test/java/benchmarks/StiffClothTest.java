package benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.implicit.ImplicitWork;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Counts behind the table, which do not depend on the machine. */
@Tag("slow")
class StiffClothTest {
    private static final double SPRINGS = 23_938;
    /**
     * Steps that rk4 needs, from 2 to 5,000: conjugate gradients are used up to 6, where they need most iterations, and
     * elimination from then on.
     */
    private static final long[] SWEEP = {2, 5, 6, 7, 100, 1000, 5000};

    @Test
    void theCostOfALinearisedStepHardlyDependsOnStiffness() {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (long steps : SWEEP) {
            double stiffness = StiffCloth.stiffnessFor(steps);
            assertEquals(steps, StiffCloth.rk4Steps(stiffness));
            ImplicitWork work = StiffCloth.linearisedWork(stiffness);
            assertEquals(steps < 7 ? 0 : 1, work.factorisations());
            least = Math.min(least, work.blockOperations());
            most = Math.max(most, work.blockOperations());
        }
        // Measured 2.69e6 products of 3 x 3 blocks in 47 iterations at 2, 7.34e6 in 130 at 6, and 7.93e6 in
        // elimination, at
        // each of the others. Where rk4 needs a single step 25 iterations are enough, 1.46e6 products. That is less
        // than a
        // quarter, but products in iterations wait for memory: the times, which gradle stiffCloth prints, are within 4.
        assertTrue(most < 3.5 * least, least + " to " + most + " products of blocks");
    }

    @Test
    void implicitStepsAreCheaperForStiffClothAndRk4ForSoftCloth() {
        double stiff = StiffCloth.linearisedWork(StiffCloth.stiffnessFor(5000)).blockOperations();
        // A product costs no more than a spring's force. Measured 60 times as many forces at 5,000 steps of RK4 ...
        assertTrue(4 * 5000 * SPRINGS > 25 * stiff, stiff + " products of blocks");
        double soft = StiffCloth.linearisedWork(StiffCloth.stiffnessFor(5)).blockOperations();
        assertTrue(4 * 5 * SPRINGS < soft / 4, soft + " products of blocks");       // ... and a thirteenth at 5
    }
}
