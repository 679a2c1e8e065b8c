package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolverException;
import deSolvers.SecondOrderStateSource;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Where verlet's closing kick is found by fixed point: when it ends well, when it gives up, and after how many evaluations. */
class ClosingKickTest {
    private static final double H = 0.5;

    /** Two blocks of two; a law for the acceleration of one entry by its own velocity, none for the others. */
    private static final class OneMoves implements SecondOrderStateSource {
        private static final int MOVING = 7;            // the last velocity; its position is entry 5
        private final DoubleUnaryOperator acceleration;
        private final double[] state = new double[8];
        private double time;
        private int evaluations;

        OneMoves(DoubleUnaryOperator acceleration) {
            this.acceleration = acceleration;
        }

        @Override
        public int getDimension() {
            return 2;
        }

        @Override
        public int getStateSize() {
            return state.length;
        }

        @Override
        public void getState(double[] copy) {
            System.arraycopy(state, 0, copy, 0, state.length);
        }

        @Override
        public void setState(double[] values) {
            System.arraycopy(values, 0, state, 0, state.length);
        }

        @Override
        public void getStateDerivative(double[] dSdt) {
            evaluations++;
            for (int x = 0; x < state.length; x += 4) {
                dSdt[x] = state[x + 2];
                dSdt[x + 1] = state[x + 3];
                dSdt[x + 2] = 0;
                dSdt[x + 3] = 0;
            }
            dSdt[MOVING] = acceleration.applyAsDouble(state[MOVING]);
        }

        @Override
        public double getTime() {
            return time;
        }

        @Override
        public void incTime(double deltaT) {
            time += deltaT;
        }
    }

    /**
     * Dry friction, whose sign follows the velocity's: no velocity satisfies the equation, and the iteration goes to and fro
     * between 0 and h a. What that moves the place by, h a h/2, is allowed to be 2^-50 of the largest position.
     */
    private static OneMoves toAndFro(double a, int position, double place) {
        OneMoves source = new OneMoves(v -> v > 0 ? -a : a);
        source.state[position] = place;
        return source;
    }

    @Test
    void whatIsRoundingOfAPositionIsEnough() {
        double a = 0x1p-50 / (H * H / 2);               // moves the place by exactly 2^-50
        for (int position : new int[] {0, 1, 4, 5}) {
            double least = position == 5 ? 1.5 : 1;     // entry 5 itself moves a little, and towards 0 from -1
            for (double place : new double[] {least, -least}) {
                OneMoves source = toAndFro(a, position, place);
                assertDoesNotThrow(() -> new VelocityVerletSolver().stepState(source, H), position + ": " + place);
                assertEquals(H, source.time);
            }
            OneMoves source = toAndFro(a, position, 0.75);
            assertThrows(DESolverException.class, () -> new VelocityVerletSolver().stepState(source, H), "position " + position);
        }
        for (int velocity : new int[] {2, 3, 6}) {      // is not what a place's rounding is measured by, and makes no place here
            OneMoves source = toAndFro(1e-3, velocity, 1e3);
            assertThrows(DESolverException.class, () -> new VelocityVerletSolver().stepState(source, H), "velocity " + velocity);
        }
    }

    /** The first evaluation of the step, then a hundred; the source is as it was. */
    @Test
    void aHundredIterationsAreTheMost() {
        OneMoves source = toAndFro(1, 0, 1);
        DESolverException e = assertThrows(DESolverException.class, () -> new VelocityVerletSolver().stepState(source, H));
        assertTrue(e.getMessage().contains("100 iterations (last change 0.5 of 0.5)"), e.getMessage());
        assertEquals(101, source.evaluations);
        assertEquals(0, source.time);
        assertEquals(0, source.state[OneMoves.MOVING]);
    }

    /**
     * Linear drag, a = -c v: the iteration gains the factor c h/2 = 1/64 at a time, and begins one factor nearer with the
     * acceleration of the beginning as a first guess: 2^-6 per iteration, 1e-13 = 2^-43 after seven and one that sees it.
     */
    @Test
    void theFirstGuessSavesAnIteration() {
        OneMoves source = new OneMoves(v -> -v / 16);
        source.state[OneMoves.MOVING] = 1;
        new VelocityVerletSolver().stepState(source, H);
        double kick = 1.0 / 64;
        // measured 1.1e-16
        assertEquals((1 - kick) / (1 + kick), source.state[OneMoves.MOVING], 1e-15, "implicit in the second half");
        assertEquals(8, source.evaluations);
    }

    /** A drag that grows beyond all bounds is no fault of the source, and no endless loop: it is said that deltaT is too long. */
    @Test
    void divergenceIsSaidToBeDivergence() {
        OneMoves source = new OneMoves(v -> -v * v * v);
        source.state[OneMoves.MOVING] = 100;
        DESolverException e = assertThrows(DESolverException.class, () -> new VelocityVerletSolver().stepState(source, H));
        assertTrue(e.getMessage().contains("too stiff for this deltaT"), e.getMessage());
        assertTrue(source.evaluations < 20, "overflows soon: " + source.evaluations);
    }

    /** After a failed step nothing is remembered: the next one begins with an evaluation of its own. */
    @Test
    void aFailedStepIsNotRemembered() {
        double[] factor = {1.0 / 16};
        OneMoves source = new OneMoves(v -> -factor[0] * v);
        source.state[OneMoves.MOVING] = 1;
        VelocityVerletSolver solver = new VelocityVerletSolver();
        solver.stepState(source, H);
        double[] begin = source.state.clone();
        factor[0] = 100;
        assertThrows(DESolverException.class, () -> solver.stepState(source, H));
        factor[0] = 1.0 / 16;
        System.arraycopy(begin, 0, source.state, 0, begin.length);
        source.evaluations = 0;
        solver.stepState(source, H);
        int after = source.evaluations;
        solver.stepState(source, H);
        assertEquals(after - 1, source.evaluations - after, "one evaluation less where the last one is remembered");
    }
}
