package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.problems.LinearPair;
import deSolvers.problems.StepMatrix;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;
import particles.experiments.stability.Amplification;

/**
 * Finds by trial how the growth of a solver's steps can be measured: on the test equation or, if it needs positions and
 * velocities or treats them differently, on springs.
 *
 * @param amplification the measurement, if there can be one
 * @param objection     the reason if there can be none; otherwise empty
 */
record StepTrial(Optional<Amplification> amplification, String objection) {
    /** Real and imaginary part of deltaT lambda, short enough for any iteration to converge. */
    private static final double[][] PLACES = {{-0.1, 0.4}, {0.05, 0.5}, {-0.2, 0.1}};
    /** Two revolutions, nearly, which no single step of a method can follow. */
    private static final double[][] FAR = {{-0.4, 12}, {-1, 12}};
    private static final double CLOSE = 0.05;
    /** A growth within so many times the noise is none. */
    private static final double CERTAIN = 10;
    /** Not a power of 2, so that a method that compares sizes is detected. */
    private static final double SIZE = 7;
    private static final int STEPS = 12;
    /**
     * The largest deviation of steps from a multiplication by a matrix that depends on deltaT lambda alone: more than
     * the residual of any iteration, less than that of adaptive sub-steps.
     */
    private static final double MOST_NOISE = 1e-7;

    /**
     * @param maker     makes solvers
     * @param remembers whether the method uses earlier steps
     * @return the way of measuring it
     */
    static StepTrial of(Supplier<DESolver> maker, boolean remembers) {
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
        return new StepTrial(Optional.empty(), objection);
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
            StepMatrix other = step(maker, springs, place, steps, 0.5, SIZE);
            noise = Math.max(noise, Math.max(one.nonlinearity(), Math.abs(one.radius() - other.radius())));
            still &= one.isIdentity();
        }
        Amplification amplification = new Amplification(maker, springs, steps > 1, CERTAIN * noise);
        if (!(noise <= MOST_NOISE)) {
            return refused("a step on a linear system does not multiply the state by a matrix that depends on deltaT"
                    + " lambda alone");
        }
        if (still) {
            return refused("a step leaves the state as it was");
        }
        if (steps == 1 && Arrays.stream(FAR).allMatch(place -> Math.abs(amplification.at(place[0], place[1])
                - StrictMath.exp(place[0])) < CLOSE)) {
            return refused("one step follows two whole revolutions, as sub-steps or an exact solution do:"
                    + " any deltaT is stable");
        }
        return new StepTrial(Optional.of(amplification), "");
    }
}
