package particles.experiments.work;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.DEStateSource;
import deSolvers.catalog.SolverInfo.Family;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.experiments.runs.CpuClock;
import particles.experiments.runs.FittedLine;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkPrecision.Point;
import particles.view.Look;

/**
 * Work-precision experiment: solves a problem with ever shorter steps or tighter tolerances, and measures the error
 * against the evaluations of the derivative and against time.
 *
 * @param problem the problem to solve
 * @param solver  the solver
 */
public record WorkPrecision(WorkProblem problem, SolverChoice solver) {
    /** A run with this error or more has no result. */
    static final double USELESS = 10;
    private static final int FEWEST_STEPS = 16;
    private static final int FEWEST_WHOLE_STEPS = 4;
    /** All runs take turns, so many rounds. */
    public static final int ROUNDS = 5;
    /** In a round, short runs are repeated until all together took this time (s). */
    private static final double ENOUGH = 5e-4;
    private static final double LOOSEST = 1e-1;
    private static final double TIGHTEST = 1e-11;
    /** A tolerance so loose that an adaptive solver does not divide a step. */
    private static final double WHOLE_STEPS = 1;

    /** The ways in which a run can fail. */
    public enum Failure {
        /** Its error grew beyond any use, or beyond all numbers. */
        UNSTABLE("unstable"),
        /** An iteration within the step did not converge, or the sub-steps became too short. */
        NOT_CONVERGED("did not converge");

        /** Its name in charts and tables. */
        final String words;

        Failure(String words) {
            this.words = words;
        }
    }

    /**
     * One run.
     *
     * @param deltaT      the step (s); for tolerances the whole duration
     * @param tolerance   the relative and absolute tolerance; NaN for fixed steps
     * @param evaluations the number of evaluations of the derivative
     * @param error       the error at the end; NaN if the run failed
     * @param times       the CPU times of the run (s) in each round, from the fastest
     * @param failure     the way in which it failed, if it did
     * @param why         the failure in words; empty if there is a result
     */
    public record Point(double deltaT, double tolerance, long evaluations, double error, List<Double> times,
                        Optional<Failure> failure, String why) {
        /** @return the time of the fastest round (s): other work on the machine only makes a round slower */
        double fastest() {
            return times.get(0);
        }

        /** @return the median of the times (s) */
        double median() {
            return CpuClock.median(times);
        }
    }

    /**
     * The work-precision curve of one solver.
     *
     * @param problem  the problem
     * @param solver   the solver
     * @param byStep   whether the step varies, by a factor of 2 from run to run; otherwise the tolerance varies, by a
     *                 factor of 10
     * @param points   the runs, from coarse to fine
     * @param fit      the exponent of the error as a power of the step, or of the evaluations with the sign changed
     * @param expected the theoretical slope; NaN if the method has no fixed order
     */
    public record Curve(WorkProblem problem, SolverChoice solver, boolean byStep, List<Point> points, SlopeFit fit,
            double expected) {
        /** @return the solver's name in charts */
        public String label() {
            return solver.label();
        }

        /** @return the solver's look in charts */
        Look look() {
            return solver.look();
        }

        /** @return the same runs, with the times of another round */
        public Curve timedAgain() {
            WorkPrecision work = new WorkPrecision(problem, solver);
            return new Curve(problem, solver, byStep, points.stream().map(point -> work.point((int) Math.round(
                    problem.duration() / point.deltaT), point.tolerance, point.times)).toList(), fit, expected);
        }

        /** @return the runs over which the slope was fitted; empty without a slope */
        List<Point> fitted() {
            return fit.runs().stream().map(points::get).toList();
        }

        Stream<Point> failures(Failure kind) {
            return points.stream().filter(point -> point.failure().equals(Optional.of(kind)));
        }
    }

    /** @return the runs of this solver, with the times of the first round */
    public Curve curve() {
        List<Point> points = byStep() ? overSteps() : overTolerances();
        double shortest = isStiff() ? problem.stiff().orElseThrow().deltaT() : 0;
        return new Curve(problem, solver, byStep(), points,
                SlopeFit.of(points, problem.floor(), byStep(), shortest), expected());
    }

    private boolean byStep() {
        return !solver.adaptive() || isStiff();
    }

    private boolean isStiff() {
        return solver.implicit() && problem.stiff().isPresent();
    }

    private long budget() {
        return solver.implicit() ? problem.budget().implicit() : problem.budget().explicit();
    }

    private double tightest() {
        return solver.implicit() ? problem.budget().tightestTolerance() : TIGHTEST;
    }

    /** The theoretical slope; an extrapolation method has none, since it varies its order. */
    private double expected() {
        double order = solver.info().filter(info -> info.family() == Family.EXTRAPOLATION).isPresent() ? Double.NaN
                : solver.order();
        return problem.stiff().map(stiff -> stiff.reduced().getOrDefault(solver.name(), order)).orElse(order);
    }

    private List<Point> overSteps() {
        List<Point> points = new ArrayList<>();
        int steps = solver.implicit() ? FEWEST_WHOLE_STEPS : FEWEST_STEPS;
        for (long next = steps; next <= budget(); steps *= 2) {
            Point point = point(steps, solver.adaptive() ? WHOLE_STEPS : Double.NaN, List.of());
            points.add(point);
            // half the step doubles the work; a run that fails early says little about it
            next = 2 * (point.failure().isPresent() ? Math.max(next, point.evaluations()) : point.evaluations());
        }
        return points;
    }

    private List<Point> overTolerances() {
        List<Point> points = new ArrayList<>();
        for (double tolerance = LOOSEST; tolerance > 0.5 * tightest(); tolerance /= 10) {
            points.add(point(1, tolerance, List.of()));
        }
        return points;
    }

    private Point point(int steps, double tolerance, List<Double> before) {
        double all = 0;
        int runs = 0;
        DEStateSource source;
        Optional<DESolverException> thrown;
        do {
            source = problem.start().get();
            DESolver fresh = solver.create(tolerance);
            double begin = CpuClock.seconds();
            thrown = solve(source, fresh, steps);
            all += CpuClock.seconds() - begin;
            runs++;
        } while (all < ENOUGH);
        List<Double> times = Stream.concat(before.stream(), Stream.of(all / runs)).sorted().toList();
        double error = problem.error(source);
        Optional<Failure> failure = thrown.map(this::kind).or(() -> error < USELESS ? Optional.empty()
                : Optional.of(Failure.UNSTABLE));
        String why = thrown.map(DESolverException::getMessage).orElse(failure.isPresent() ? "the error is " + error
                : "");
        return new Point(problem.duration() / steps, tolerance, WorkProblem.evaluations(source),
                failure.isPresent() ? Double.NaN : error, times, failure, why);
    }

    /**
     * Finds the way of failing: an overflow has an entry of the state, an iteration that does not converge has none,
     * and sub-steps become too short.
     */
    private Failure kind(DESolverException thrown) {
        return thrown.getEntry() < 0 || solver.adaptive() ? Failure.NOT_CONVERGED : Failure.UNSTABLE;
    }

    private Optional<DESolverException> solve(DEStateSource source, DESolver fresh, int steps) {
        try {
            for (int n = 0; n < steps; n++) {
                fresh.stepState(source, problem.duration() / steps);
            }
            return Optional.empty();
        } catch (DESolverException e) {
            return Optional.of(e);
        }
    }

    /**
     * The slope of a solver's errors over the three finest runs whose errors are small and above round-off.
     *
     * @param slope  the exponent; NaN if there are no three such runs on a straight line
     * @param runs   the runs of the fit, by their places in the list; none without a slope
     * @param whyNot the reason if there is no slope; empty otherwise
     */
    public record SlopeFit(double slope, List<Integer> runs, String whyNot) {
        /** Errors above this are too large to follow the power law. */
        static final double SMALL = 0.1;
        /**
         * The largest difference of the slopes from run to run on a line that counts as straight: 0.18 for radau on the
         * stiff chain, 0.48 for rk4 there, at the edge of stability.
         */
        private static final double STRAIGHT = 0.25;
        /** The same for tolerances, which a solver follows only roughly. */
        private static final double ROUGHLY_STRAIGHT = 1;

        /**
         * @param points   runs with ever shorter steps, or ever tighter tolerances
         * @param floor    errors below this may be round-off
         * @param byStep   whether the slope is that of the error as a power of deltaT; otherwise of the evaluations,
         *                 with the sign changed
         * @param shortest runs with shorter steps (s) are left out
         * @return the slope over the three finest that remain, if they are on a straight line
         */
        static SlopeFit of(List<Point> points, double floor, boolean byStep, double shortest) {
            List<Integer> usable = IntStream.range(0, points.size()).filter(k -> points.get(k).failure().isEmpty()
                    && points.get(k).error() < SMALL && points.get(k).error() > floor
                    && points.get(k).deltaT() >= shortest).boxed().toList();
            if (usable.size() < FittedLine.FEWEST) {
                return new SlopeFit(Double.NaN, List.of(), usable.size() + " errors between "
                        + Digits.few(floor) + " and " + Digits.few(SMALL) + "; a slope needs " + FittedLine.FEWEST);
            }
            List<Integer> finest = usable.subList(usable.size() - FittedLine.FEWEST, usable.size());
            double[] x = finest.stream().map(points::get).mapToDouble(point -> Math.log(byStep ? point.deltaT()
                    : 1.0 / point.evaluations())).toArray();
            double[] y = finest.stream().mapToDouble(k -> Math.log(points.get(k).error())).toArray();
            double bend = (y[2] - y[1]) / (x[2] - x[1]) - (y[1] - y[0]) / (x[1] - x[0]);
            return Math.abs(bend) <= (byStep ? STRAIGHT : ROUGHLY_STRAIGHT)
                    ? new SlopeFit(FittedLine.of(x, y).slope(), finest, "")
                    : new SlopeFit(Double.NaN, List.of(), "not on a straight line");
        }
    }
}
