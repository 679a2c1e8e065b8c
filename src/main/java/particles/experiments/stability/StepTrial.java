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
            return on(maker, !(step(maker, false, PLACES[0], steps, 1, 1).distinction() <= MOST_NOISE), steps);
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

    /** Steps of the test equation at a place, or of the spring with these eigenvalues, undamped if they grow. */
    private static StepMatrix step(Supplier<DESolver> maker, boolean springs, double[] place, int steps, double deltaT,
            double size) {
        double re = place[0] / deltaT;
        double im = place[1] / deltaT;
        return StepMatrix.of(maker.get(), springs ? LinearPair.spring(re * re + im * im, -2 * Math.min(0, re))
                : LinearPair.testEquation(re, im), steps, deltaT, size);
    }

    private static StepTrial on(Supplier<DESolver> maker, boolean springs, int steps) {
        double noise = 0;
        boolean still = true;
        for (double[] place : PLACES) {
            StepMatrix one = step(maker, springs, place, steps, 1, 1);
            if (one.difference(step(maker, springs, place, steps, 1, 1)) > 0) {
                return refused("two steps from the same place are not the same");
            }
            double bent = Math.max(one.nonlinearity(), one.difference(step(maker, springs, place, steps, 1, SIZE)));
            if (!(bent <= MOST_NOISE)) {
                return refused("a step on a linear system does not multiply the state by a matrix, as the length of"
                        + " sub-steps or an iteration depends on the state");
            }
            StepMatrix half = step(maker, springs, place, steps, 0.5, 1);
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
            step = step(maker, springs, FAR, 1, 1, 1);
        } catch (RuntimeException e) {                  // whatever the solver throws at such a step
            return false;
        }
        return Math.abs(step.determinant() - StrictMath.exp(2 * FAR[0])) < CLOSE
                && Math.abs(step.xx() + step.vv() - 2 * StrictMath.exp(FAR[0]) * StrictMath.cos(FAR[1])) < CLOSE;
    }
}
