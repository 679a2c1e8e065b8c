package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.problems.StiffSpringPair;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.experiments.runs.FewestSteps;
import particles.experiments.runs.FittedLine;
import particles.experiments.runs.RunCharts;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.SolverStability;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;

/**
 * Measures the cost of stiffness: two masses swing slowly, whatever the stiffness of the spring between them, while
 * this spring gets stiffer and stiffer. For each stiffness it finds the evaluations that a solver needs to stay stable,
 * and to find the swing to 1 %.
 */
public final class StiffGallery {
    private static final double DURATION = 10;
    private static final double PRECISION = 0.01;
    /**
     * A solver without a limit is precise only where the energy of the seed grows by less than this factor, far more
     * than its oscillation in a stable run.
     */
    private static final double UNSTABLE = 1e4;
    private static final int MOST_STEPS = 1 << 20;
    private static final double NEAR = 1.01;
    /** A run is stable if its step is shorter than this part of the solver's limit. */
    private static final double BELOW_LIMIT = 0.99;
    private static final double FIT_FROM = 1e3;
    private static final Axis STIFFNESS = Axis.log("stiffness k", "N/m");
    /** Smaller values are drawn as this one: the vibration is gone. */
    private static final double GONE = 1e-16;

    /**
     * The cost of one solver at one stiffness; NaN if no number of steps is enough.
     *
     * @param solver       the solver
     * @param stiffness    the stiffness of the spring between the masses (N/m)
     * @param toBeStable   the evaluations of the cheapest stable run; NaN also for an adaptive solver
     * @param toOnePercent the evaluations of the cheapest run whose swing is right to 1 %
     * @param vibrationLeft the energy of the stiff vibration divided by that at the start; the largest value in the
     *                      last tenth of that run, since it oscillates with a symplectic solver close to its limit
     */
    public record Cost(SolverChoice solver, double stiffness, double toBeStable, double toOnePercent,
                       double vibrationLeft) {
    }

    /**
     * The result of a run: the error of the centre, the rest of the vibration, and its evaluations.
     */
    private record Run(double error, double vibration, long evaluations) {
        boolean precise() {
            return vibration < UNSTABLE && error <= PRECISION;
        }
    }

    private StiffGallery() {
    }

    /**
     * @param solver  the solver
     * @param decades the number of decades of stiffness, from 1 N/m
     * @return its costs, from soft to stiff
     */
    public static List<Cost> sweep(SolverChoice solver, int decades) {
        double limit = solver.adaptive() ? Double.NaN : SolverStability.of(solver).undamped().value();
        return IntStream.rangeClosed(0, decades).mapToObj(d -> cost(solver, StrictMath.pow(10, d), limit)).toList();
    }

    private static Cost cost(SolverChoice solver, double k, double limit) {
        if (solver.adaptive()) {
            Run run = run(solver, k, 1, PRECISION);
            for (double t = PRECISION; !run.precise() && t > 1e-9; t /= 3) {
                run = run(solver, k, 1, t);
            }
            return new Cost(solver, k, Double.NaN, run.precise() ? run.evaluations() : Double.NaN,
                    run.precise() ? run.vibration() : Double.NaN);
        }
        int stable = limit == 0 ? 1 : (int) Math.max(2, Math.ceil(DURATION * new StiffSpringPair(k).omega()
                / (BELOW_LIMIT * limit)));
        int precise = FewestSteps.find(2, MOST_STEPS / (solver.implicit() ? 16 : 1), NEAR, steps -> steps >= stable
                && run(solver, k, steps, 0).precise());
        Run best = run(solver, k, Math.max(1, precise), 0);
        return new Cost(solver, k, limit == 0 ? Double.NaN : run(solver, k, stable, 0).evaluations(),
                precise == 0 ? Double.NaN : best.evaluations(), precise == 0 ? Double.NaN : best.vibration());
    }

    private static Run run(SolverChoice choice, double k, int steps, double tolerance) {
        StiffSpringPair pair = new StiffSpringPair(k);
        DESolver solver = choice.create(tolerance);
        double left = vibration(solver, pair, DURATION / steps, steps);
        return new Run(Math.abs(pair.centre() - StrictMath.cos(DURATION)), left, pair.getEvaluations());
    }

    /** The largest vibration in the last tenth of some steps; infinite, or that of a step where it grew too far. */
    private static double vibration(DESolver solver, StiffSpringPair pair, double deltaT, int steps) {
        double left = 0;
        try {
            for (int n = 0; n < steps && left < UNSTABLE; n++) {
                solver.stepState(pair, deltaT);
                double vibration = pair.vibration();
                if (n >= 0.9 * (steps - 1) || !(vibration < UNSTABLE)) {
                    left = Math.max(left, vibration);
                }
            }
            return left;
        } catch (DESolverException e) {
            return Double.POSITIVE_INFINITY;            // it overflows
        }
    }

    /**
     * @param costs the costs of all solvers
     * @return charts over the stiffness: evaluations for an error of 1 %, evaluations needed to be stable, and for
     *         solvers that can be stable, the rest of the vibration; at the curves, the exponents of evaluations
     */
    public static List<Chart> charts(List<Cost> costs) {
        List<Chart> charts = new ArrayList<>(charts(costs, "evaluations for 1 % error of the swing", "",
                Cost::toOnePercent, some -> power(some, Cost::toOnePercent)));
        charts.addAll(charts(costs.stream().filter(cost -> !cost.solver.adaptive()).toList(),
                "evaluations to be stable", "evaluations-to-be-stable", Cost::toBeStable,
                some -> power(some, Cost::toBeStable)));
        charts.addAll(charts(costs.stream().filter(cost -> !Double.isNaN(cost.toBeStable) || cost.solver.implicit())
                .toList(), "fast-mode energy, end / start (\u2265 " + Digits.few(GONE) + ")", "fast-mode-energy-end",
                cost -> Math.max(GONE, cost.vibrationLeft), some -> ""));
        return charts;
    }

    private static List<Chart> charts(List<Cost> costs, String quantity, String name, ToDoubleFunction<Cost> value,
            Function<List<Cost>, String> end) {
        return RunCharts.of(costs, Cost::solver, STIFFNESS, Cost::stiffness).charts(Axis.log(quantity, ""), value, end)
                .stream().map(chart -> chart.named(name)).toList();
    }

    private static String power(List<Cost> costs, ToDoubleFunction<Cost> evaluations) {
        double exponent = exponent(costs, evaluations);
        return Double.isNaN(exponent) ? "no exponent" : "k^" + Digits.few(exponent, 2);
    }

    /** The exponent of the stiffness in a cost, to two decimals: those after that come from whole numbers of steps. */
    static double exponent(List<Cost> costs, ToDoubleFunction<Cost> evaluations) {
        double fitted = FittedLine.exponent(costs.stream().filter(cost -> cost.stiffness >= FIT_FROM
                && !Double.isNaN(evaluations.applyAsDouble(cost))).toList(), Cost::stiffness, evaluations);
        return Double.isNaN(fitted) ? fitted : Math.round(100 * fitted) / 100.0;
    }

    /**
     * @param sweeps the costs of each solver
     * @return the exponents, and the cost for the softest and the stiffest spring
     */
    public static DataTable table(List<List<Cost>> sweeps) {
        return DataTable.of("stiffness", """
                Evaluations grow as a power of the stiffness k: to be stable, and for an error of 1 % of the swing. \
                Then, the evaluations for 1 % with the softest and the stiffest spring""", sweeps,
                column("solver", sweep -> sweep.get(0).solver.label()),
                column("exponent of k, to be stable", 3, sweep -> exponent(sweep, Cost::toBeStable)),
                column("exponent of k, for 1 % error", 3, sweep -> exponent(sweep, Cost::toOnePercent)),
                column("evaluations for 1 % error, softest spring", sweep -> sweep.get(0).toOnePercent),
                column("evaluations for 1 % error, stiffest spring", sweep ->
                        sweep.get(sweep.size() - 1).toOnePercent));
    }
}
