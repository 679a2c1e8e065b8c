package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import org.junit.jupiter.api.Test;

/**
 * Tests {@link LastStep}: a step continues the last one only if all is bit for bit the same. {@link DESolverContract}
 * tests it with every solver.
 */
class LastStepTest {
    private static final double DELTA_T = 0.5;

    private static final DEStateSource SOURCE = at(3);

    private static ReferenceProblem at(double time) {
        ReferenceProblem source = new Oscillator();
        source.startAt(time);
        return source;
    }

    /** The memory of a step that ended at the source's present state and time. */
    private static LastStep after(DEStateSource source, double deltaT) {
        LastStep lastStep = new LastStep();
        keep(lastStep, source, deltaT);
        return lastStep;
    }

    private static void keep(LastStep lastStep, DEStateSource source, double deltaT) {
        double[] state = new double[source.getStateSize()];
        source.getState(state);
        source.incTime(-deltaT);
        StepTransaction step = new StepTransaction(EulerSolver.class).begin(source, deltaT);
        lastStep.keep(step, state);
        step.finish(state);
    }

    private static boolean continues(LastStep lastStep, DEStateSource source, double deltaT) {
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(source, deltaT)) {
            return lastStep.continuesFrom(step);
        }
    }

    @Test
    void zerosOfDifferentSignAreDifferent() {
        ReferenceProblem source = at(3);
        source.setState(new double[] {0.0, 1});
        LastStep lastStep = after(source, DELTA_T);
        source.setState(new double[] {-0.0, 1});
        assertFalse(continues(lastStep, source, DELTA_T));
    }

    /** A loop may set the clock to a multiple of deltaT; that is off by the round-off of an addition at most. */
    @Test
    void theClockMayBeOffByRoundOff() {
        ReferenceProblem source = at(3);
        for (int ulps : new int[] {-9, -1, 0, 1, 9}) {
            source.startAt(3);
            LastStep lastStep = after(source, DELTA_T);
            source.incTime(ulps * Math.ulp(3.0));
            assertEquals(Math.abs(ulps) <= 2, continues(lastStep, source, DELTA_T), ulps + " ulps");
        }
    }

    @Test
    void aStepIsContinuedAtMostOnce() {
        LastStep lastStep = new LastStep();
        assertFalse(continues(lastStep, SOURCE, DELTA_T), "there was no step yet");
        keep(lastStep, SOURCE, DELTA_T);
        assertTrue(continues(lastStep, SOURCE, DELTA_T));
        assertFalse(continues(lastStep, SOURCE, DELTA_T), "the step that continued it has not ended");
        keep(lastStep, SOURCE, DELTA_T);
        assertFalse(continues(lastStep, at(3), DELTA_T));
        assertFalse(continues(lastStep, SOURCE, DELTA_T), "another step has begun since");
        keep(lastStep, SOURCE, DELTA_T);
        lastStep.forget();
        assertFalse(continues(lastStep, SOURCE, DELTA_T), "forgotten");
    }
}
