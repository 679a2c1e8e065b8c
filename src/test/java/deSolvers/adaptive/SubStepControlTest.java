package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolverException;
import deSolvers.problems.Steps;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The sequence of sub-steps tried by step-size control, with errors given by the test. */
class SubStepControlTest {
    private static final double CLOSE = 1e-14;          // up to 9 round-offs of sums and roots; measured 1.8e-15

    private static Ramp constant() {
        return new Ramp(0, t -> 1);
    }

    /** From s = 0, s' = 1 the guess is the root of a hundredth: 0.1. */
    private static final double FIRST = 0.1;

    private static void assertTried(List<Double> tried, double... expected) {
        assertArrayEquals(expected, tried.stream().limit(expected.length).mapToDouble(Double::doubleValue).toArray(),
                CLOSE);
    }

    private static Scripted step(double deltaT, DoubleBinaryOperator error) {
        Scripted solver = new Scripted(false, error);
        solver.stepState(constant(), deltaT);
        return solver;
    }

    private static Scripted step(double deltaT, double growth) {
        return step(deltaT, h -> growth);
    }

    private static Scripted step(double deltaT, DoubleUnaryOperator growth) {
        Scripted solver = new Scripted(0.81);
        solver.growth = growth;
        solver.stepState(constant(), deltaT);
        return solver;
    }

    /** The next sub-step is 0.9 error^(-1/2) times as long, limited to between a fifth and ten times. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.25, 0.81, 0.01, 0.0081, 1e-4, 0})
    void lengthsFollowTheError(double error) {
        double factor = Math.min(10, 0.9 / Math.sqrt(error));
        int[] tried = {0};
        Scripted solver = step(1e4, (offset, h) -> tried[0]++ < 2 ? error : 0.01);
        assertTried(solver.tried, FIRST, FIRST * factor, FIRST * factor * factor);
        assertTried(solver.offsets, 0, FIRST, FIRST * (1 + factor));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.0000001, 2, 4, 20, 20.25, 21, 1e6, Double.POSITIVE_INFINITY})
    void aRejectedSubStepIsTriedAgainShorter(double error) {
        double factor = Math.max(0.2, 0.9 / Math.sqrt(error));
        Scripted solver = step(10, (offset, h) -> offset < 0.05 && h > 0.9 * FIRST * factor * factor ? error : 0.81);
        // 0.81 asks for the same length again.
        assertTried(solver.tried, FIRST, FIRST * factor, FIRST * factor * factor);
        assertTried(solver.offsets, 0, 0, 0);
    }

    /** Even if a method proposes a longer sub-step after a rejection, it becomes shorter. */
    @Test
    void noSubStepGrowsRightAfterARejection() {
        Scripted solver = new Scripted(false, (offset, h) -> offset == 0 && h > 0.85 * FIRST ? 2 : 0.5);
        solver.growth = h -> 3;
        solver.stepState(constant(), 1000);
        double h = FIRST * 0.9 * 0.9;
        assertTried(solver.tried, FIRST, FIRST * 0.9, h, h, 3 * h, 9 * h);
        assertTried(solver.offsets, 0, 0, 0, h, 2 * h, 5 * h);
    }

    /**
     * The rest of a step is split into two halves rather than a long and a tiny sub-step; the last ends exactly at
     * deltaT.
     */
    @Test
    void theLastSubStepEndsExactlyAtDeltaT() {
        for (double direction : new double[] {1, -1}) {
            assertTried(step(direction * 0.25, 1.0625).tried, direction * FIRST, direction * 0.075, direction * 0.075);
            assertTried(step(direction * 0.35, 1.0625).tried, direction * FIRST, direction * 0.10625,
                    direction * 0.071875,
                    direction * 0.071875);
            assertEquals(3, step(direction * 0.25, 1.0625).tried.size());
            assertEquals(4, step(direction * 0.35, 1.0625).tried.size());
            Scripted one = step(direction * 0.09375, (offset, h) -> 0.81);
            assertEquals(List.of(direction * 0.09375), one.tried);
        }
    }

    /**
     * A sub-step that was shortened to end at deltaT does not shorten the next step's first one, if it was accepted.
     */
    @Test
    void aShortenedLastSubStepKeepsThePlannedLength() {
        Scripted solver = new Scripted(0.0081);                         // asks for ten times more
        Ramp source = constant();
        solver.stepState(source, 0.5);
        assertTried(solver.tried, 0.1, 0.4);            // 1 was planned; ten times 0.4 is more than that
        solver.tried.clear();
        solver.stepState(source, 0.5);
        assertTried(solver.tried, 0.5);
        // Well is: the next could be twice as long, or longer. 1 is planned when 0.13125 is left.
        for (double growth : new double[] {1.9375, 2, 2.0625}) {
            Scripted plan = new Scripted(0.81);
            plan.growth = h -> plan.tried.size() < 5 ? 1 : plan.tried.size() == 5 ? 10 : growth;
            Ramp other = constant();
            plan.stepState(other, 0.63125);
            assertTried(plan.tried, 0.1, 0.1, 0.1, 0.1, 0.1, 0.13125);
            plan.stepState(other, 0.63125);
            assertEquals(growth < 2 ? 0.13125 * growth : 0.63125, plan.tried.get(6), CLOSE);
        }
        // One that was not cut is what it is.
        Scripted whole = step(10, (offset, h) -> 0.0081);
        assertTried(whole.tried, 0.1, 1, 8.9);
    }

    /** The slope at the end of a sub-step is taken from the method if it knows it, otherwise evaluated once. */
    @Test
    void eachSubStepGetsTheSlopeAtItsBeginning() {
        for (boolean known : new boolean[] {false, true}) {
            for (double direction : new double[] {1, -1}) {
                Scripted solver = new Scripted(known, (offset, h) -> Math.abs(offset) > 0.15 && Math.abs(h) > 0.05 ? 2
                        : 0.81);
                Ramp source = new Ramp(0, t -> 1 + t / 8);
                solver.stepState(source, direction * 2);
                for (int k = 0; k < solver.tried.size(); k++) {
                    double offset = solver.offsets.get(k);
                    assertEquals(offset == 0 ? 1 : known ? 100 + offset : 1 + offset / 8, solver.slopes.get(k), CLOSE);
                }
                long accepted = solver.offsets.stream().distinct().count();
                // At the beginning, for the first guess, and where each but the first one begins.
                assertEquals(known ? 2 : 1 + accepted, source.asked.size());
                assertEquals(direction * 2, source.getTime());
            }
        }
    }

    @Test
    void givingUpNamesPlaceAndReason() {
        Scripted never = new Scripted(false, (offset, h) -> offset > 0.15 ? 2 : 0.81);
        Ramp source = constant();
        DESolverException e = assertThrows(DESolverException.class, () -> never.stepState(source, 1));
        assertTrue(e.getMessage()
                .matches(".*the sub-step fell to 1\\.11\\S+E-16 s after 0.2\\d* s, where the resolution of the"
                + " clock is 1\\.11\\S+E-16 s, and still cannot be made.*"), e.getMessage());
        // 4 ulp of what was done: a sub-step of exactly that was tried last.
        assertEquals(4 * Math.ulp(0.2), never.tried.get(never.tried.size() - 1));
        assertEquals(0, source.getTime());

        Scripted slow = new Scripted(0.81);
        slow.growth = h -> slow.tried.size() < 496_000 ? 1 + 1e-5 : 0.99;      // they grow, and give hope, to the last
        Steps.assertFails(DESolverException.class, "given up after 500000 sub-steps",
                () -> slow.stepState(constant(), 1.45e6));
        assertEquals(AdaptiveSolver.MOST_SUB_STEPS, slow.tried.size());
        // A clock far from 0 resolves less.
        Scripted late = new Scripted(2);
        Ramp far = constant();
        far.incTime(1e6);
        Steps.assertFails(DESolverException.class, "the resolution of the clock is " + 4 * Math.ulp(1e6) + " s",
                () -> late.stepState(far, 1));
        assertEquals(4 * Math.ulp(1e6), late.tried.get(late.tried.size() - 1));
        // But deltaT itself may be as short as it likes.
        Scripted tiny = new Scripted(0.5);
        tiny.stepState(far, 1e-300);
        assertEquals(List.of(1e-300), tiny.tried);
    }

    /** Of 500,000 sub-steps that may be tried, a step that needs a million of one length tries few. */
    @Test
    void aStepThatMakesNoHeadwayIsGivenUpEarly() {
        Scripted slow = new Scripted(0.81);
        DESolverException e = assertThrows(DESolverException.class, () -> slow.stepState(constant(), 1e5));
        assertTrue(e.getMessage().contains("given up after " + slow.tried.size() + " sub-steps"), e.getMessage());
        assertTrue(slow.tried.size() <= 30_000, slow.tried.size() + " sub-steps");         // measured: 20,000
        Scripted growing = new Scripted(0.5);
        growing.growth = h -> 1.0005;
        growing.stepState(constant(), 1e9);             // as hopeless after 10,000, but the next ones are longer
        assertEquals(30_858, growing.tried.size(), 10);
    }

    /** A guess below the clock's resolution is raised to it. */
    @Test
    void noSubStepIsFinerThanTheClock() {
        double resolution = 4 * Math.ulp(1e9);
        Ramp far = new Ramp(2, t -> 1e12);              // the guess is 2e-12
        far.incTime(1e9);
        Scripted good = new Scripted(0.0081);
        good.stepState(far, 1);
        assertEquals(resolution, good.tried.get(0));
        for (double deltaT : new double[] {1, 1e-7}) {  // below the resolution deltaT is all that can be tried
            Scripted bad = new Scripted(2);
            far.incTime(1e9 - far.getTime());
            far.setState(new double[] {2});
            assertThrows(DESolverException.class, () -> bad.stepState(far, deltaT));
            assertEquals(List.of(Math.min(deltaT, resolution)), bad.tried);
        }
        // Of two halves each may be shorter than the resolution, and is the last to be tried.
        Scripted halves = new Scripted(2);
        assertThrows(DESolverException.class, () -> halves.stepState(far, 1.5 * resolution));
        assertEquals(List.of(0.75 * resolution), halves.tried);
    }

    @Test
    void aNonFiniteDerivativeIsNamedWhenItIsAskedFor() {
        Scripted solver = new Scripted(0.81);
        Steps.assertFails(DESolverException.class, "entry 0 of the derivative is NaN at t = 0.2",
                () -> solver.stepState(new Ramp(0, t -> t > 0.15 && t < 0.9 ? Double.NaN : 1), 1));
        assertEquals(2, solver.tried.size());
    }
}
