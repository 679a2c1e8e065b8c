package benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.implicit.ImplicitWork;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The counts behind the table: they do not depend on the machine. */
@Tag("slow")
class StiffClothTest {
    private static final double SPRINGS = 23_938;
    /** From where rk4 needs two steps to 5,000: conjugate gradients up to 7, where they need most, and then elimination. */
    private static final long[] SWEEP = {2, 5, 7, 8, 100, 1000, 5000};

    @Test
    void aLinearisedStepCostsMuchTheSameHoweverManyStepsRk4Needs() {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (long steps : SWEEP) {
            double stiffness = StiffCloth.stiffnessFor(steps);
            assertEquals(steps, StiffCloth.rk4Steps(stiffness));
            ImplicitWork work = StiffCloth.linearisedWork(stiffness);
            assertEquals(steps < 8 ? 0 : 1, work.factorisations());
            least = Math.min(least, work.blockOperations());
            most = Math.max(most, work.blockOperations());
        }
        // Measured 2.69e6 products of 3 x 3 blocks in 47 iterations at 2, 8.52e6 in 151 at 7, and 9.18e6 in elimination, at
        // each of the others. Where rk4 needs a single step 25 iterations are enough: there nobody takes an implicit one.
        assertTrue(most < 4 * least, least + " to " + most + " products of blocks");
    }

    @Test
    void theStiffestClothIsCheaperByFarWithOneImplicitStepAndASoftOneWithRk4() {
        double stiff = StiffCloth.linearisedWork(StiffCloth.stiffnessFor(5000)).blockOperations();
        // A product costs no more than a spring's force. Measured 52 times as many forces at 5,000 steps of RK4 ...
        assertTrue(4 * 5000 * SPRINGS > 25 * stiff, stiff + " products of blocks");
        double soft = StiffCloth.linearisedWork(StiffCloth.stiffnessFor(5)).blockOperations();
        assertTrue(4 * 5 * SPRINGS < soft / 4, soft + " products of blocks");       // ... and a thirteenth at 5
    }
}
