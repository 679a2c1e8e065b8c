package particles.experiments;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.DEStateSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import particles.experiments.problems.WorkProblem;

/**
 * What precision costs: a problem solved with ever shorter steps, or tighter tolerances, and the error set against the
 * evaluations of the derivative and against time.
 */
public final class WorkPrecision {
    /** An error of so much is no result. */
    private static final double USELESS = 10;
    /** Errors between these belong to the method: above, it is not yet small, below, digits run out. */
    private static final double NOT_YET = 0.1;
    private static final double FLOOR = 3e-11;
    private static final int FITTED = 3;
    private static final int FEWEST_STEPS = 16;
    private static final int REPEATS = 3;
    /** A run that takes longer than this needs no repetition for the clock's sake (s). */
    private static final double LONG = 0.2;
    private static final double TIGHTEST = 1e-11;

    /**
     * One run.
     *
     * @param deltaT      the step (s); for adaptive solvers the whole duration
     * @param tolerance   relative and absolute; NaN for fixed steps
     * @param evaluations of the derivative
     * @param error       at the end; NaN where the run failed
     * @param seconds     the median of three runs, or one long one, after one to warm up
     * @param least       the fastest of them (s)
     * @param most        the slowest (s)
     * @param failure     why there is no result, if there is none
     */
    public record Point(double deltaT, double tolerance, long evaluations, double error, double seconds, double least, double most,
                        Optional<String> failure) {
    }

    /**
     * One solver's runs.
     *
     * @param solver   which
     * @param points   from loose to tight
     * @param slope    of the error over the step, or for adaptive solvers over the evaluations with the sign changed; NaN
     *                 where too few errors are in range
     * @param expected the solver's order
     */
    public record Curve(SolverChoice solver, List<Point> points, double slope, double expected) {
    }

    private WorkPrecision() {
    }

    /**
     * @param problem to be solved
     * @param solver  by whom
     * @return its runs
     */
    public static Curve measure(WorkProblem problem, SolverChoice solver) {
        List<Point> points = new ArrayList<>();
        if (solver.adaptive()) {
            for (double tolerance = 1e-1; tolerance > 0.5 * TIGHTEST; tolerance /= 10) {
                Point point = point(problem, solver, 1, tolerance);
                points.add(point);
                if (point.evaluations() > problem.mostWork() / (solver.implicit() ? 4 : 1)
                        || point.failure().isPresent() && point.evaluations() > problem.mostWork() / 4) {
                    break;
                }
            }
        } else {
            long evaluations = 0;
            for (int steps = FEWEST_STEPS; 2 * evaluations <= problem.mostWork() / (solver.implicit() ? 12 : 1); steps *= 2) {
                Point point = point(problem, solver, steps, Double.NaN);
                points.add(point);
                evaluations = Math.max(point.evaluations(), 2 * evaluations);
            }
        }
        return new Curve(solver, points, slope(points, solver.adaptive()), solver.order());
    }

    private static Point point(WorkProblem problem, SolverChoice solver, int steps, double tolerance) {
        double deltaT = problem.duration() / steps;
        DEStateSource source = problem.start().get();
        long start = System.nanoTime();
        Optional<String> failure = solve(source, solver.create(tolerance), deltaT, steps);
        double[] seconds = new double[(System.nanoTime() - start) * 1e-9 > LONG ? 1 : REPEATS];
        double error = problem.error(source);
        if (failure.isEmpty() && !(error < USELESS)) {
            failure = Optional.of("unstable: the error is " + error);
        }
        long evaluations = problem.evaluations().applyAsLong(source);
        for (int k = 0; k < seconds.length; k++) {             // the run above has warmed up
            DEStateSource again = problem.start().get();
            DESolver fresh = solver.create(tolerance);
            long begin = System.nanoTime();
            solve(again, fresh, deltaT, steps);
            seconds[k] = (System.nanoTime() - begin) * 1e-9;
        }
        Arrays.sort(seconds);
        return new Point(deltaT, tolerance, evaluations, failure.isPresent() ? Double.NaN : error, seconds[seconds.length / 2], seconds[0],
                seconds[seconds.length - 1], failure);
    }

    private static Optional<String> solve(DEStateSource source, DESolver solver, double deltaT, int steps) {
        try {
            for (int n = 0; n < steps; n++) {
                solver.stepState(source, deltaT);
            }
            return Optional.empty();
        } catch (DESolverException e) {
            return Optional.of(e.getMessage());
        }
    }

    /** The straight line through the last errors in range, by least squares in logarithms. */
    private static double slope(List<Point> points, boolean byEvaluations) {
        List<Point> fit = points.stream().filter(p -> p.error() < NOT_YET && p.error() > FLOOR).toList();
        fit = fit.subList(Math.max(0, fit.size() - FITTED), fit.size());
        return slope(fit.stream().mapToDouble(p -> byEvaluations ? 1.0 / p.evaluations() : p.deltaT()).toArray(),
                fit.stream().mapToDouble(Point::error).toArray());
    }

    /** @return the exponent of y as a power of x; NaN for fewer than three points */
    static double slope(double[] x, double[] y) {
        if (x.length < 3) {
            return Double.NaN;
        }
        double meanX = Arrays.stream(x).map(StrictMath::log).average().orElse(0);
        double meanY = Arrays.stream(y).map(StrictMath::log).average().orElse(0);
        double products = 0;
        double squares = 0;
        for (int k = 0; k < x.length; k++) {
            double dx = StrictMath.log(x[k]) - meanX;
            products += dx * (StrictMath.log(y[k]) - meanY);
            squares += dx * dx;
        }
        return products / squares;
    }
}
