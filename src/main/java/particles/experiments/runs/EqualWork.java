package particles.experiments.runs;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.scene.format.SceneDescription;

/**
 * Finds the step, or for adaptive solvers the tolerance, with which a run of a scene costs a number of evaluations of
 * the derivative, or the least that it can cost.
 *
 * @param scene  the scene to run, for its duration
 * @param target the number of evaluations wanted, 1 or more
 * @param frames the number of parts of the duration, 1 or more: an adaptive solver's steps end with one of them
 */
public record EqualWork(SceneDescription scene, long target, int frames) {
    private static final int TRIALS = 14;
    /** Exponents of the loosest tolerance that makes sense and of the tightest. */
    private static final double LOOSEST = -1;
    private static final double TIGHTEST = -13;
    /** The largest number of steps of an adaptive solver, and the evaluations for each, with its sub-steps. */
    private static final int ADAPTIVE_STEPS = 200;
    private static final int EVALUATIONS_A_STEP = 14;

    /** @return the setting of a solver whose cost comes nearest */
    public Setting find(SolverChoice solver) {
        return solver.adaptive() ? byTolerance(solver) : bySteps(solver);
    }

    /** The cost of a step changes little with its length, so proportion finds the number of steps. */
    private Setting bySteps(SolverChoice solver) {
        Set<Long> tried = new HashSet<>();
        long best = 1;
        double off = Double.POSITIVE_INFINITY;
        long steps = Math.max(1, Math.round(target / 4.0));
        while (tried.add(steps) && tried.size() <= TRIALS) {
            Outcome outcome = run(Setting.of(solver, scene.duration() / steps));
            double cost = cost(outcome);
            // a first step that fails does not show what a step costs: a shorter one may not fail
            if (outcome.steps() > 0 && Math.abs(cost - target) < off || off == Double.POSITIVE_INFINITY) {
                best = steps;
                off = outcome.steps() > 0 ? Math.abs(cost - target) : Double.POSITIVE_INFINITY;
            }
            steps = outcome.steps() == 0 ? steps + (steps + 1) / 2
                    : Math.max(1, Math.round(steps * (target / cost)));
        }
        return Setting.of(solver, scene.duration() / best);
    }

    /** Bisects the exponent of the tolerance; a run that fails asks for a tighter one. */
    private Setting byTolerance(SolverChoice solver) {
        long most = Math.max(1, Math.min(ADAPTIVE_STEPS, target / EVALUATIONS_A_STEP));
        int steps = IntStream.rangeClosed(1, frames).filter(d -> frames % d == 0 && d <= most).max().orElseThrow();
        double loose = LOOSEST;
        double tight = TIGHTEST;
        double exponent = loose;
        double best = loose;
        double off = Double.POSITIVE_INFINITY;
        for (int trial = 0; trial < TRIALS; trial++) {
            Outcome outcome = run(setting(solver, steps, exponent));
            double cost = cost(outcome);
            if (outcome.whole() && Math.abs(cost - target) < off) {
                best = exponent;
                off = Math.abs(cost - target);
            }
            if (outcome.whole() && cost >= target) {
                tight = exponent;
            } else {
                loose = exponent;
            }
            exponent = (loose + tight) / 2;             // the loosest one, if that costs too much
        }
        return setting(solver, steps, best);
    }

    private Setting setting(SolverChoice solver, int steps, double exponent) {
        return new Setting(solver, scene.duration() / steps, Optional.of(StrictMath.pow(10, exponent)));
    }

    private Outcome run(Setting setting) {
        return SceneRun.run(SceneRun.build(scene, setting), List.of());
    }

    /** The evaluations of a run; of one that ends early, those of the whole duration by proportion. */
    private double cost(Outcome outcome) {
        double part = outcome.whole() || outcome.endTime() == 0 ? 1 : outcome.endTime() / scene.duration();
        return Math.max(1, outcome.evaluations() / part);
    }
}
