package particles.experiments.stability;

import deSolvers.DESolver;
import deSolvers.problems.LinearPair;
import deSolvers.problems.StepMatrix;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Finds by trial how the growth of a solver's steps can be measured: on the test equation or, if it needs positions and
 * velocities or treats them differently, on springs.
 *
 * @param amplification the measurement, if there can be one
 * @param noise         the deviation of steps from a multiplication by a matrix that depends on deltaT lambda alone:
 *                      round-off, or the residual of an iteration
 * @param objection     the reason if there can be none; otherwise empty
 */
public record StepTrial(Optional<Amplification> amplification, double noise, String objection) {
    /** Real and imaginary part of deltaT lambda, short enough for any iteration to converge. */
    private static final double[][] PLACES = {{-0.1, 0.4}, {0.05, 0.5}, {-0.2, 0.1}};
    /** Two revolutions, nearly. */
    private static final double[] FAR = {-0.4, 12};
    private static final double CLOSE = 0.05;
    /** Not a power of 2, so that a method that compares sizes is detected. */
    private static final double SIZE = 7;
    private static final int STEPS = 12;
    /** The largest deviation: more than the residual of any iteration, less than that of adaptive sub-steps. */
    private static final double MOST_NOISE = 1e-7;

    /**
     * @param maker     makes solvers
     * @param remembers whether the method uses earlier steps
     * @return the way of measuring it
     */
    public static StepTrial of(Supplier<DESolver> maker, boolean remembers) {
        int steps = remembers ? STEPS : 1;
        try {
            StepMatrix first = StepMatrix.of(maker.get(), source(false, PLACES[0], 1), steps, 1, 1);
            return on(maker, !(first.distinction() <= MOST_NOISE), steps);
        } catch (RuntimeException refusal) {            // whatever a solver throws that has to know the velocities
            try {
                return on(maker, true, steps);
            } catch (RuntimeException e) {
                return refused("a step on a linear system ends in " + refusal);
            }
        }
    }

    private static StepTrial refused(String objection) {
        return new StepTrial(Optional.empty(), Double.NaN, objection);
    }

    /** The test equation at a multiple of a place, or the spring with these eigenvalues, undamped if they grow. */
    private static LinearPair source(boolean springs, double[] place, double factor) {
        double re = factor * place[0];
        double im = factor * place[1];
        return springs ? LinearPair.spring(re * re + im * im, -2 * Math.min(0, re)) : LinearPair.testEquation(re, im);
    }

    private static StepTrial on(Supplier<DESolver> maker, boolean springs, int steps) {
        double noise = 0;
        boolean still = true;
        for (double[] place : PLACES) {
            StepMatrix one = StepMatrix.of(maker.get(), source(springs, place, 1), steps, 1, 1);
            StepMatrix again = StepMatrix.of(maker.get(), source(springs, place, 1), steps, 1, 1);
            if (one.difference(again) > 0) {
                return refused("two steps from the same place are not the same");
            }
            StepMatrix large = StepMatrix.of(maker.get(), source(springs, place, 1), steps, 1, SIZE);
            double bent = Math.max(one.nonlinearity(), one.difference(large));
            if (!(bent <= MOST_NOISE)) {
                return refused("a step on a linear system does not multiply the state by a matrix, as the length of"
                        + " sub-steps or an iteration depends on the state");
            }
            StepMatrix half = StepMatrix.of(maker.get(), source(springs, place, 2), steps, 0.5, 1);
            double apart = springs ? Math.abs(one.radius() - half.radius()) : one.difference(half);
            if (!(apart <= MOST_NOISE)) {
                return refused("a step with half the deltaT and twice the lambda"
                        + " is another one: it does not follow deltaT");
            }
            noise = Math.max(noise, Math.max(bent, apart));
            still &= one.isIdentity();
        }
        if (still) {
            return refused("a step leaves the state as it was");
        }
        if (steps == 1 && isExact(maker, springs)) {
            return refused("one step follows two whole revolutions, as sub-steps or an exact solution do:"
                    + " any deltaT is stable");
        }
        return new StepTrial(Optional.of(new Amplification(maker, springs, steps > 1)), noise, "");
    }

    /** Whether one step follows two revolutions, which no single step of a method can. */
    private static boolean isExact(Supplier<DESolver> maker, boolean springs) {
        StepMatrix step;
        try {
            step = StepMatrix.of(maker.get(), source(springs, FAR, 1), 1, 1, 1);
        } catch (RuntimeException e) {                  // whatever the solver throws at such a step
            return false;
        }
        return Math.abs(step.determinant() - StrictMath.exp(2 * FAR[0])) < CLOSE
                && Math.abs(step.xx() + step.vv() - 2 * StrictMath.exp(FAR[0]) * StrictMath.cos(FAR[1])) < CLOSE;
    }
}
