package benchmarks;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import particles.experiments.runs.FewestSteps;

/**
 * One of our solvers beside one of Hipparchus' integrators, both on one workload: either the same method with the same
 * steps, which compares the overhead between equal evaluations; or each with the coarsest setting that reaches an error
 * of {@value #ERROR}, which also compares step-size control.
 */
record Comparison(Plan plan, Run ours, Run.Outcome oursFound, Run theirs, Run.Outcome theirsFound) {
    static final double ERROR = 1e-6;
    static final int STEPS = 64;
    private static final double LOOSEST = 1e-2;
    private static final double TIGHTEST = 1e-13;
    private static final int HALVINGS = 4;
    private static final int MOST_STEPS = 1 << 16;

    /**
     * A planned comparison.
     *
     * @param equalError whether at equal error, otherwise at equal evaluations
     * @param workload the problem
     * @param ours       our solver
     * @param theirs     their integrator
     */
    record Plan(boolean equalError, String workload, String ours, String theirs) {
        @Override
        public String toString() {
            return "comparison " + workload + " " + ours + " " + theirs + " equal " + atEqual();
        }

        String atEqual() {
            return equalError ? "error" : "evaluations";
        }
    }

    static List<Plan> plans() {
        List<Plan> plans = new ArrayList<>();
        for (String workload : Workload.NAMES) {
            plans.add(new Plan(false, workload, "euler", "Euler"));
            plans.add(new Plan(false, workload, "midpoint", "Midpoint"));
            plans.add(new Plan(false, workload, "rk4", "ClassicalRungeKutta"));
        }
        for (String workload : Workload.NAMES) {
            plans.add(new Plan(true, workload, "rk4", "ClassicalRungeKutta"));
            plans.add(new Plan(true, workload, "dormand-prince", "DormandPrince54"));
            plans.add(new Plan(true, workload, "bulirsch-stoer", "GraggBulirschStoer"));
            plans.add(new Plan(true, workload, "adams", "AdamsMoulton"));
        }
        return plans;
    }

    /** Finds the settings at which the two are comparable. */
    static Comparison of(Plan plan) {
        Workload workload = Workload.of(plan.workload());
        double duration = plan.equalError() ? workload.duration() : STEPS * workload.deltaT();
        double[] reference = workload.reference(duration);
        Function<String, Run> run = method -> plan.equalError() ? coarsest(workload, method, reference)
                : Run.steps(plan.workload(), method, duration, STEPS);
        Run ours = run.apply(plan.ours());
        Run theirs = run.apply(plan.theirs());
        return new Comparison(plan, ours, ours.outcome(workload, reference), theirs,
                theirs.outcome(workload, reference));
    }

    private static Run coarsest(Workload workload, String method, double[] reference) {
        return Method.isAdaptive(method) ? byTolerance(workload, method, reference) : bySteps(workload, method,
                reference);
    }

    /**
     * The loosest tolerance, by half decades and then by bisection; errors of adaptive methods jump, so a finer search
     * is useless.
     */
    private static Run byTolerance(Workload workload, String method, double[] reference) {
        double loose = Math.log10(LOOSEST);
        double tight = loose;
        while (!reaches(tolerance(workload, method, tight), workload, reference)) {
            loose = tight;
            tight -= 0.5;
            if (tight < Math.log10(TIGHTEST)) {
                throw missed(method, workload);
            }
        }
        for (int k = 0; k < HALVINGS && loose > tight; k++) {
            double middle = (loose + tight) / 2;
            if (reaches(tolerance(workload, method, middle), workload, reference)) {
                tight = middle;
            } else {
                loose = middle;
            }
        }
        return tolerance(workload, method, tight);
    }

    private static Run tolerance(Workload workload, String method, double exponent) {
        return Run.tolerance(workload.name(), method, workload.duration(), StrictMath.pow(10, exponent));
    }

    private static Run bySteps(Workload workload, String method, double[] reference) {
        int steps = FewestSteps.find(16, MOST_STEPS, 1, enough ->
                reaches(steps(workload, method, enough), workload, reference));
        if (steps == 0) {
            throw missed(method, workload);
        }
        return steps(workload, method, steps);
    }

    private static IllegalStateException missed(String method, Workload workload) {
        return new IllegalStateException(method + " does not reach an error of " + ERROR + " on the "
                + workload.name());
    }

    private static Run steps(Workload workload, String method, int steps) {
        return Run.steps(workload.name(), method, workload.duration(), steps);
    }

    private static boolean reaches(Run run, Workload workload, double[] reference) {
        return run.outcome(workload, reference).error() <= ERROR;
    }
}
