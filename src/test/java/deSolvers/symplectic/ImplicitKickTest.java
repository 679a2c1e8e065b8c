package deSolvers.symplectic;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.problems.LinearPair;
import deSolvers.problems.SecondOrderProblem;
import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Where verlet's closing kick is found by fixed point: when it ends well, when it gives up, and after how many
 * evaluations.
 */
class ImplicitKickTest {
    private static final double H = 0.5;

    /**
     * Two blocks of d, of 2 where nothing else is said; a law for the acceleration of one entry by its own velocity,
     * none for the others.
     */
    private static class OneMoves extends SecondOrderProblem {
        private static final int MOVING = 7;            // the last velocity where d is 2; its position is entry 5
        private final DoubleUnaryOperator acceleration;

        OneMoves(DoubleUnaryOperator acceleration) {
            this(2, acceleration);
        }

        OneMoves(int d, DoubleUnaryOperator acceleration) {
            super(d, new double[4 * d]);
            this.acceleration = acceleration;
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            int d = getDimension();
            Arrays.fill(dSdt, d, 2 * d, 0);
            Arrays.fill(dSdt, 3 * d, 4 * d, 0);
            dSdt[4 * d - 1] = acceleration.applyAsDouble(s[4 * d - 1]);
        }

        OneMoves with(int entry, double value) {
            double[] s = getState();
            s[entry] = value;
            setState(s);
            return this;
        }
    }

    /**
     * Dry friction, whose sign follows the velocity's: no velocity satisfies the equation, and the iteration goes to
     * and fro between 0 and h a. What that moves the place by, h a h/2, is allowed to be 2^-50 of the largest position.
     */
    private static OneMoves toAndFro(int d, double a, int position, double place) {
        return new OneMoves(d, v -> v > 0 ? -a : a).with(position, place);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void whatIsRoundingOfAPositionIsEnough(int d) {
        double a = 0x1p-50 / (H * H / 2);               // moves the place by exactly 2^-50
        for (int entry = 0; entry < 4 * d - 1; entry++) {
            if (entry % (2 * d) >= d) {                 // a velocity is not what a place's rounding is measured by
                OneMoves source = toAndFro(d, 1e-3, entry, 1e3);
                assertThrows(DESolverException.class, () -> new VelocityVerletSolver().stepState(source, H),
                        "velocity " + entry);
                continue;
            }
            // its position itself moves a little, and towards 0 from -1
            double least = entry == 3 * d - 1 ? 1.5 : 1;
            for (double place : new double[] {least, -least}) {
                OneMoves source = toAndFro(d, a, entry, place);
                assertDoesNotThrow(() -> new VelocityVerletSolver().stepState(source, H), entry + ": " + place);
                assertEquals(H, source.getTime());
            }
            OneMoves source = toAndFro(d, a, entry, 0.75);
            assertThrows(DESolverException.class, () -> new VelocityVerletSolver().stepState(source, H),
                    "position " + entry);
        }
    }

    /** The first evaluation of the step, then a hundred; the source is as it was. */
    @Test
    void aHundredIterationsAreTheMost() {
        OneMoves source = toAndFro(2, 1, 0, 1);
        Steps.assertFails(DESolverException.class, "100 iterations; the last change is 0.5 of 0.75; ",
                () -> new VelocityVerletSolver().stepState(source, H));
        assertEquals(101, source.getEvaluations());
        assertEquals(0, source.getTime());
        assertEquals(0, source.getState()[OneMoves.MOVING]);
    }

    /**
     * Linear drag, a = -c v: the iteration gains the factor c h/2 = 1/64 at a time, and begins one factor nearer with
     * the acceleration of the beginning as a first guess: 2^-6 per iteration, 1e-13 = 2^-43 after seven and one that
     * sees it.
     */
    @Test
    void theFirstGuessSavesAnIteration() {
        OneMoves source = new OneMoves(v -> -v / 16).with(OneMoves.MOVING, 1);
        new VelocityVerletSolver().stepState(source, H);
        double kick = 1.0 / 64;
        // measured 1.1e-16
        assertEquals((1 - kick) / (1 + kick), source.getState()[OneMoves.MOVING], 1e-15, "implicit in the second half");
        assertEquals(8, source.getEvaluations());
    }

    /**
     * Where the kick stops what moved, its length is what it is measured by: relative to the velocity that is left,
     * which is 0, no change would ever be small. With a = -126 - v/16 from v = 64 the first kick leaves 31.5, and the
     * closing one takes them: 0 solves 31.5 - (126 + v/16)/4 = v. Each iteration leaves 2^-6 of v: from -0.5 on,
     * 31.5e-13 are reached in seven.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void whatStopsIsMeasuredByHowFastItWas(int d) {
        OneMoves source = new OneMoves(d, v -> -126 - v / 16);
        int moving = 4 * d - 1;
        source.with(moving, 64);
        new VelocityVerletSolver().stepState(source, H);
        assertEquals(0, source.getState()[moving], 3e-14);           // measured 3.6e-15, a rounding of 31.5
        assertEquals(31.5 * H, source.getState()[moving - d]);       // measured 0: all of it is exact in binary
        assertEquals(9, source.getEvaluations(), "the step's first one, seven, and one that sees it");
    }

    /**
     * Where nothing moved before and a force sets in within the step, what it gives in the first round is the measure:
     * v = (1 - v/16)/4 from 0, by 1/4 in the first round and 2^-6 of the last change in each later one, down to 1e-13
     * of 1/4 in the ninth.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void whatBeginsToMoveIsMeasuredByItsFirstRound(int d) {
        OneMoves source = new OneMoves(d, v -> 1 - v / 16) {
            @Override
            public void getStateDerivative(double[] dSdt) {
                super.getStateDerivative(dSdt);
                dSdt[dSdt.length - 1] *= getTime() > 0 ? 1 : 0;
            }
        };
        new VelocityVerletSolver().stepState(source, H);
        assertEquals(16.0 / 65, source.getState()[4 * d - 1], 1e-15);        // measured 0
        assertEquals(10, source.getEvaluations(), "the step's first one and nine");
    }

    /**
     * A drag that grows beyond all bounds is no fault of the source, and no endless loop: it is said that deltaT is too
     * long.
     */
    @Test
    void divergenceIsSaidToBeDivergence() {
        OneMoves source = new OneMoves(v -> -v * v * v).with(OneMoves.MOVING, 100);
        Steps.assertFails(DESolverException.class, "too stiff for this deltaT",
                () -> new VelocityVerletSolver().stepState(source, H));
        assertBelow(20, source.getEvaluations(), "overflows soon");
    }

    /** Numbers below 1e-308 have fewer digits: the iteration must not wait for more. */
    @Test
    void aMotionThatDiesOutIsSolvedToTheLastDigit() {
        for (DESolver solver : new DESolver[] {new VelocityVerletSolver(), new Yoshida4Solver()}) {
            LinearPair spring = LinearPair.spring(1, 2);        // critically damped
            spring.start(1);
            double h = solver instanceof VelocityVerletSolver ? 0.7 : 0.4;
            Steps.make(3000, solver, spring, h);
            for (double entry : spring.getState()) {
                assertEquals(0, entry, 1e-300);
            }
        }
    }

    /** After a failed step nothing is remembered: the next one begins with an evaluation of its own. */
    @Test
    void aFailedStepIsNotRemembered() {
        double[] factor = {1.0 / 16};
        OneMoves source = new OneMoves(v -> -factor[0] * v).with(OneMoves.MOVING, 1);
        VelocityVerletSolver solver = new VelocityVerletSolver();
        solver.stepState(source, H);
        double[] begin = source.getState();
        factor[0] = 100;
        assertThrows(DESolverException.class, () -> solver.stepState(source, H));
        factor[0] = 1.0 / 16;
        source.setState(begin);
        long before = source.getEvaluations();
        solver.stepState(source, H);
        long after = source.getEvaluations();
        solver.stepState(source, H);
        assertEquals(after - before - 1, source.getEvaluations() - after,
                "one evaluation less where the last one is remembered");
    }
}
