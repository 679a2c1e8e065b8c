package particles.experiments.work;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.problems.StiffSpringPair;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.experiments.runs.FewestSteps;
import particles.experiments.runs.FittedLine;
import particles.experiments.runs.SolverChoice;

/**
 * Measures the cost of stiffness: two masses swing slowly, whatever the stiffness of the spring between them, while
 * this spring gets stiffer and stiffer. For each stiffness it finds the evaluations that a solver needs to stay stable,
 * and to find the swing to 1 %.
 */
public final class StiffGallery {
    private static final double DURATION = 10;
    private static final double PRECISION = 0.01;
    /**
     * A run counts as unstable if the energy of the seed grows by this factor, far more than its oscillation in a
     * stable run.
     */
    private static final double UNSTABLE = 1e4;
    /**
     * In few steps nothing grows so much, so a short run goes on until it has made this number of steps. That detects a
     * growth of 0.5 % per step, which rk4 has when its step is 0.03 % too long.
     */
    private static final int STEPS_TO_GROW = 2000;
    private static final int MOST_STEPS = 1 << 20;
    private static final double NEAR = 1.01;
    /**
     * A long run of short steps shows the solvers that grow at any step: the slowest, adams, grows by 5e-3, while means
     * of waves differ by 5e-5.
     */
    private static final double SHORT_STEP = 0.1;
    private static final int LONG_RUN = 20_000;
    private static final double GROWTH = 1 + 5e-4;
    static final double FIT_FROM = 1e3;

    /**
     * The cost of one solver at one stiffness; NaN if no number of steps is enough.
     *
     * @param stiffness    the stiffness of the spring between the masses (N/m)
     * @param toBeStable   the evaluations of the cheapest stable run
     * @param toOnePercent the evaluations of the cheapest run whose swing is right to 1 %
     * @param vibrationLeft the energy of the stiff vibration divided by that at the start; the largest value in the
     *                      last tenth of that run, since it oscillates with a symplectic solver close to its limit
     */
    public record Cost(double stiffness, double toBeStable, double toOnePercent, double vibrationLeft) {
    }

    /**
     * The costs of one solver over all stiffnesses.
     *
     * @param solver      the solver
     * @param neverStable whether the undamped vibration grows at any step
     * @param costs       its costs, from soft to stiff
     */
    public record Sweep(SolverChoice solver, boolean neverStable, List<Cost> costs) {
        /** @return the exponent of the stiffness in a cost; NaN if there is none */
        public double exponent(ToDoubleFunction<Cost> evaluations) {
            return FittedLine.exponent(costs.stream().filter(cost -> cost.stiffness() >= FIT_FROM
                    && !Double.isNaN(evaluations.applyAsDouble(cost))).toList(), Cost::stiffness, evaluations);
        }
    }

    /**
     * The result of a run: the error of the centre, the rest of the vibration, whether it is stable, and its
     * evaluations.
     */
    private record Run(double error, double vibration, boolean stable, long evaluations) {
        boolean precise() {
            return stable && error <= PRECISION;
        }
    }

    private StiffGallery() {
    }

    /**
     * @param solver  the solver
     * @param decades the number of decades of stiffness, from 1 N/m
     * @return its costs
     */
    public static Sweep sweep(SolverChoice solver, int decades) {
        boolean never = grows(solver);
        return new Sweep(solver, never, IntStream.rangeClosed(0, decades)
                .mapToObj(d -> cost(solver, StrictMath.pow(10, d), never)).toList());
    }

    private static Cost cost(SolverChoice solver, double k, boolean never) {
        if (solver.adaptive()) {
            Run run = run(solver, k, 1, PRECISION, 0);
            for (double t = PRECISION; !run.precise() && t > 1e-9; t /= 3) {
                run = run(solver, k, 1, t, 0);
            }
            return new Cost(k, Double.NaN, run.precise() ? run.evaluations() : Double.NaN,
                    run.precise() ? run.vibration() : Double.NaN);
        }
        int toGrow = never ? 0 : STEPS_TO_GROW;         // a solver that always grows only grows more
        int stable = never ? 0 : fewest(solver, k, toGrow, Run::stable);
        int precise = fewest(solver, k, toGrow, Run::precise);
        Run best = run(solver, k, Math.max(1, precise), 0, 0);
        return new Cost(k, stable == 0 ? Double.NaN : run(solver, k, stable, 0, 0).evaluations(),
                precise == 0 ? Double.NaN : best.evaluations(), precise == 0 ? Double.NaN : best.vibration());
    }

    private static int fewest(SolverChoice solver, double k, int toGrow, Predicate<Run> enough) {
        return FewestSteps.find(2, MOST_STEPS / (solver.implicit() ? 16 : 1), NEAR, steps ->
                enough.test(run(solver, k, steps, 0, toGrow)));
    }

    private static Run run(SolverChoice choice, double k, int steps, double tolerance, int toGrow) {
        StiffSpringPair pair = new StiffSpringPair(k);
        DESolver solver = choice.create(tolerance);
        double left = vibration(solver, pair, DURATION / steps, steps);
        double error = Math.abs(pair.centre() - StrictMath.cos(DURATION));
        long evaluations = pair.getEvaluations();
        return new Run(error, left, left < UNSTABLE
                && vibration(solver, pair, DURATION / steps, toGrow - steps) < UNSTABLE, evaluations);
    }

    /** The largest vibration in the last tenth of some steps; infinite, or that of a step where it is unstable. */
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

    private static boolean grows(SolverChoice choice) {
        if (choice.adaptive()) {
            return false;
        }
        StiffSpringPair pair = new StiffSpringPair(1);
        DESolver solver = choice.create(0);
        double[] quarters = new double[4];
        for (int n = 0; n < LONG_RUN; n++) {
            solver.stepState(pair, SHORT_STEP / pair.omega());
            quarters[4 * n / LONG_RUN] += pair.vibration();
        }
        return quarters[3] > GROWTH * quarters[0];
    }
}
