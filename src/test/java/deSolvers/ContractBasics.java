package deSolvers;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.DragInWind;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.SecondOrderProblem;
import java.util.function.Supplier;

/** Base class of contract tests: a test problem, and comparison with a solver that has no memory of earlier steps. */
public abstract class ContractBasics {
    static final double START = 0.3;
    static final double STEP = 0.1;
    static final double[] NOT_FINITE = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};

    private final Supplier<DESolver> maker;

    ContractBasics(Supplier<DESolver> maker) {
        this.maker = maker;
    }

    /** @return a new solver */
    protected final DESolver createSolver() {
        return maker.get();
    }

    /** A problem that exercises everything: three dimensions, drag, and a wind that depends on time. */
    static SecondOrderProblem windy(int blocks) {
        SecondOrderProblem problem = new DragInWind(3, blocks);
        problem.startAt(START);
        return problem;
    }

    static void assertSameBits(ReferenceProblem expected, ReferenceProblem actual, String when) {
        assertArrayEquals(expected.getState(), actual.getState(), when);          // no tolerance: bit for bit
        assertEquals(expected.getTime(), actual.getTime(), when);
    }

    final void assertStepsLikeNew(DESolver used, SecondOrderProblem from, double deltaT, String when) {
        SecondOrderProblem other = windy(from.getStateSize() / 6);
        moveTo(other, from);
        createSolver().stepState(other, deltaT);
        used.stepState(from, deltaT);
        assertSameBits(other, from, when);
    }

    static void moveTo(ReferenceProblem cursor, ReferenceProblem place) {
        cursor.setState(place.getState());
        cursor.incTime(place.getTime() - cursor.getTime());
        assertEquals(place.getTime(), cursor.getTime());
    }
}
