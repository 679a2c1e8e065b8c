package particles.experiments.work;

import static particles.view.DataTable.column;

import java.util.List;
import java.util.function.IntFunction;
import particles.experiments.runs.FewestSteps;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkPrecision.Run;
import particles.view.DataTable;

/** The lecture's exercise: "Estimate cost of RK4 versus midpoint for similar accuracy", on x'' = -x over 100 s. */
public final class CostExercise {
    private static final int MOST_STEPS = 1 << 24;
    private static final List<Double> ERRORS = List.of(1e-1, 1e-2, 1e-3, 1e-4, 1e-6);

    private CostExercise() {
    }

    /**
     * @param error    the error of the state at the end
     * @param midpoint the evaluations that the midpoint method needs
     * @param rk4      the evaluations that RK4 needs
     */
    public record Cost(double error, long midpoint, long rk4) {
    }

    /** @return the costs for errors from 0.1 to one in a million */
    public static List<Cost> solve() {
        WorkProblem oscillator = WorkProblem.of("oscillator");
        return ERRORS.stream().map(error -> new Cost(error, fewest(oscillator, "midpoint", error),
                fewest(oscillator, "rk4", error))).toList();
    }

    /** The evaluations of the fewest steps that reach the error; in this range it falls with each additional step. */
    private static long fewest(WorkProblem problem, String solver, double error) {
        IntFunction<Run> run = steps -> WorkPrecision.run(problem, SolverChoice.of(solver), steps, Double.NaN);
        return run.apply(FewestSteps.find(200, MOST_STEPS, 1, steps -> run.apply(steps).error() <= error))
                .evaluations();
    }

    /**
     * @param costs the result of {@link #solve}
     * @return the answer to the exercise
     */
    public static DataTable table(List<Cost> costs) {
        return DataTable.of("exercise",
                "The slides' exercise: evaluations of midpoint and RK4 for the same error, on x'' = -x over 100 s",
                costs, column("error", Cost::error), column("midpoint", Cost::midpoint), column("rk4", Cost::rk4),
                column("midpoint / rk4", 2, cost -> (double) cost.midpoint() / cost.rk4()));
    }
}
