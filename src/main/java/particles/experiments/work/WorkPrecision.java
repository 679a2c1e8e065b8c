package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.DEStateSource;
import deSolvers.catalog.SolverInfo.Family;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import particles.experiments.runs.CpuClock;
import particles.experiments.runs.FittedLine;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.RunCharts;
import particles.experiments.runs.SolverChoice;
import particles.view.Axis;
import particles.view.DataTable;
import particles.view.Panel;

/**
 * Work-precision experiment: solves a problem with ever shorter steps or tighter tolerances, and measures the error
 * against the evaluations of the derivative and against time.
 */
public final class WorkPrecision {
    /** A run with this error or more has no result. */
    private static final double USELESS = 10;
    private static final int FEWEST_STEPS = 16;
    private static final int FEWEST_WHOLE_STEPS = 4;
    /** All runs take turns, so many rounds. */
    private static final int ROUNDS = 5;
    /** In a round, short runs are repeated until all together took this time (s). */
    private static final double ENOUGH = 5e-4;
    private static final double LOOSEST = 1e-1;
    private static final double TIGHTEST = 1e-11;
    /** A tolerance so loose that an adaptive solver does not divide a step. */
    private static final double WHOLE_STEPS = 1;
    /** Errors above this are too large to follow the power law. */
    private static final double SMALL = 0.1;
    /**
     * The largest difference of the slopes from run to run on a line that counts as straight: 0.18 for radau on the
     * stiff chain, 0.48 for rk4 there, at the edge of stability.
     */
    private static final double STRAIGHT = 0.25;
    /** The same for tolerances, which a solver follows only roughly. */
    private static final double ROUGHLY_STRAIGHT = 1;

    private WorkPrecision() {
    }

    /**
     * One run.
     *
     * @param problem     the problem
     * @param solver      the solver
     * @param deltaT      the step (s); for tolerances the whole duration
     * @param tolerance   the relative and absolute tolerance; NaN for fixed steps
     * @param evaluations the number of evaluations of the derivative
     * @param error       the error at the end; NaN if the run failed
     * @param seconds     the CPU time of the run in the fastest round (s): other work on the machine only makes a
     *                    round slower
     * @param failure     the reason if it failed; empty otherwise
     */
    public record Run(WorkProblem problem, SolverChoice solver, double deltaT, double tolerance, long evaluations,
                      double error, double seconds, String failure) {
        private Run again() {
            Run other = run(problem, solver, (int) Math.round(problem.duration() / deltaT), tolerance);
            return other.seconds < seconds ? other : this;
        }
    }

    /**
     * All runs take turns, round by round, so that other work on the machine slows down one round of many.
     *
     * @param problems the problems
     * @param solvers  the solvers
     * @param progress receives the progress
     * @return the runs of each solver on each problem, from coarse to fine
     */
    public static List<Run> measure(List<WorkProblem> problems, List<SolverChoice> solvers,
            ProgressListener progress) {
        double part = 1.0 / ROUNDS;
        List<Run> runs = progress.part(0, part).parts(problems, (problem, some) -> some.each(solvers, solver ->
                solver.label() + " on " + problem.name(), solver -> runs(problem, solver))).stream()
                .flatMap(List::stream).flatMap(List::stream).toList();
        for (int round = 1; round < ROUNDS; round++) {
            runs = progress.part(part * round, part * (round + 1)).each(runs, run -> run.solver.label() + " on "
                    + run.problem.name(), Run::again);
        }
        return runs;
    }

    /**
     * Halves the step, or divides the tolerance by 10, as long as the work allows.
     *
     * @return the runs, with the times of one round
     */
    static List<Run> runs(WorkProblem problem, SolverChoice solver) {
        List<Run> runs = new ArrayList<>();
        boolean bySteps = isBySteps(problem, solver);
        int steps = !bySteps ? 1 : solver.implicit() ? FEWEST_WHOLE_STEPS : FEWEST_STEPS;
        double tolerance = !bySteps ? LOOSEST : solver.adaptive() ? WHOLE_STEPS : Double.NaN;
        long most = solver.implicit() ? problem.mostImplicit() : problem.mostExplicit();
        for (long next = steps; next <= most && (bySteps || tolerance > TIGHTEST / 2);) {
            Run run = run(problem, solver, steps, tolerance);
            runs.add(run);
            // half the step doubles the work; a run that fails early says little about it
            next = 2 * (run.failure.isEmpty() ? run.evaluations : Math.max(next, run.evaluations));
            steps *= bySteps ? 2 : 1;
            tolerance /= bySteps ? 1 : 10;
        }
        return runs;
    }

    /** Implicit solvers are compared at equal steps where a problem is stiff, also the adaptive ones. */
    private static boolean isBySteps(WorkProblem problem, SolverChoice solver) {
        return !solver.adaptive() || solver.implicit() && problem.isStiff();
    }

    static Run run(WorkProblem problem, SolverChoice solver, int steps, double tolerance) {
        double deltaT = problem.duration() / steps;
        double all = 0;
        int runs = 0;
        DEStateSource source;
        String failure;
        do {
            source = problem.start().get();
            DESolver fresh = solver.create(tolerance);
            double begin = CpuClock.seconds();
            failure = solve(source, fresh, steps, deltaT);
            all += CpuClock.seconds() - begin;
            runs++;
        } while (all < ENOUGH);
        double error = problem.error(source);
        String why = failure.isEmpty() && !(error < USELESS) ? "the error is " + Digits.few(error) : failure;
        return new Run(problem, solver, deltaT, tolerance, WorkProblem.evaluations(source),
                why.isEmpty() ? error : Double.NaN, all / runs, why);
    }

    private static String solve(DEStateSource source, DESolver fresh, int steps, double deltaT) {
        try {
            for (int n = 0; n < steps; n++) {
                fresh.stepState(source, deltaT);
            }
            return "";
        } catch (DESolverException e) {
            return e.getMessage();
        }
    }

    /** The theoretical slope; an extrapolation method has none, since it varies its order. */
    static double theory(WorkProblem problem, SolverChoice solver) {
        return solver.info().filter(info -> info.family() == Family.EXTRAPOLATION).isPresent() ? Double.NaN
                : problem.reduced().getOrDefault(solver.name(), solver.order());
    }

    /**
     * The slope over the three finest of one solver's runs whose errors are small and above round-off.
     *
     * @param runs runs with ever shorter steps, or ever tighter tolerances
     * @return the exponent of the error as a power of deltaT, or with tolerances of the evaluations, with the sign
     *         changed; NaN if there are no three such runs on a straight line
     */
    static double slope(List<Run> runs) {
        WorkProblem problem = runs.get(0).problem;
        SolverChoice solver = runs.get(0).solver;
        boolean bySteps = isBySteps(problem, solver);
        double shortest = solver.implicit() ? problem.stiffDeltaT() : 0;
        List<Run> usable = runs.stream().filter(run -> run.error < SMALL && run.error > problem.floor()
                && run.deltaT >= shortest).toList();
        if (usable.size() < FittedLine.FEWEST) {
            return Double.NaN;
        }
        List<Run> finest = usable.subList(usable.size() - FittedLine.FEWEST, usable.size());
        double[] x = finest.stream().mapToDouble(run -> Math.log(bySteps ? run.deltaT : 1.0 / run.evaluations))
                .toArray();
        double[] y = finest.stream().mapToDouble(run -> Math.log(run.error)).toArray();
        double bend = (y[2] - y[1]) / (x[2] - x[1]) - (y[1] - y[0]) / (x[1] - x[0]);
        return Math.abs(bend) <= (bySteps ? STRAIGHT : ROUGHLY_STRAIGHT) ? FittedLine.slope(x, y) : Double.NaN;
    }

    /**
     * @param runs the runs of all solvers on one problem
     * @return error against evaluations, with the slopes at the curves
     */
    public static Panel byEvaluations(List<Run> runs) {
        return panel(runs, Axis.log("evaluations of the derivative", ""), Run::evaluations, WorkPrecision::slopes);
    }

    /**
     * @param runs the runs of all solvers on one problem
     * @return error against CPU time
     */
    public static Panel byTime(List<Run> runs) {
        return panel(runs, Axis.log("CPU time, fastest round", "s"), Run::seconds, some -> "");
    }

    private static Panel panel(List<Run> runs, Axis work, ToDoubleFunction<Run> place,
            Function<List<Run>, String> end) {
        WorkProblem problem = runs.get(0).problem;
        return Panel.of(problem.title() + ": error against " + work.quantity(),
                RunCharts.of(runs, Run::solver, work, place).charts(problem.errorAxis(), Run::error, end));
    }

    /** The slope of a solver, and in brackets the theoretical one. */
    static String slopes(List<Run> runs) {
        double slope = slope(runs);
        double theory = theory(runs.get(0).problem, runs.get(0).solver);
        return Double.isNaN(slope) ? "no slope" : Digits.format("%.2f", slope)
                + (Double.isNaN(theory) ? "" : Digits.format(" (%.0f)", theory));
    }

    /**
     * @param runs the runs of all solvers on all problems
     * @return the slope of each solver on each problem, and the theoretical one
     */
    public static DataTable slopeTable(List<Run> runs) {
        return DataTable.of("slopes",
                "Slopes beside theory, each over the three finest runs above round-off, if they are on a straight line",
                List.copyOf(runs.stream().collect(Collectors.groupingBy(run -> List.of(run.problem, run.solver),
                        LinkedHashMap::new, Collectors.toList())).values()),
                column("problem", curve -> curve.get(0).problem.name()),
                column("solver", curve -> curve.get(0).solver.label()), column("slope", 3, WorkPrecision::slope),
                column("theory", curve -> theory(curve.get(0).problem, curve.get(0).solver)));
    }

    /**
     * @param runs the runs of all solvers on all problems
     * @return a row for each
     */
    public static DataTable table(List<Run> runs) {
        return DataTable.of("runs", "Every run; the CPU time is that of the fastest of " + ROUNDS + " rounds", runs,
                column("problem", run -> run.problem.name()), column("solver", run -> run.solver.label()),
                column("deltaT (s)", Run::deltaT), column("tolerance", 2, Run::tolerance),
                column("evaluations", Run::evaluations), column("error", 3, Run::error),
                column("CPU time (s)", 2, Run::seconds), column("what went wrong", Run::failure));
    }
}
