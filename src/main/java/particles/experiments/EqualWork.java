package particles.experiments;

import java.util.List;
import java.util.Optional;
import particles.experiments.SceneRun.Outcome;
import particles.experiments.SceneRun.Setting;
import particles.scene.SceneDescription;

/**
 * Finds the step, or for adaptive solvers the tolerance, with which a run of a scene costs a given number of evaluations of
 * the derivative.
 */
public final class EqualWork {
    private static final int TRIALS = 14;
    private static final double LOOSEST = 0.1;
    private static final double TIGHTEST = 1e-13;
    /** An adaptive solver is given this many steps; sub-steps do the rest. */
    private static final int ADAPTIVE_STEPS = 50;

    /**
     * @param setting     how to solve
     * @param evaluations what that costs
     * @param aStep       evaluations in one of its steps, on average
     */
    public record Match(Setting setting, long evaluations, double aStep) {
    }

    private final SceneDescription scene;
    private final double duration;
    private final long target;

    /**
     * @param scene    what is to run
     * @param duration how long (s)
     * @param target   evaluations of the derivative, 1 or more
     */
    public EqualWork(SceneDescription scene, double duration, long target) {
        this.scene = scene;
        this.duration = duration;
        this.target = target;
    }

    /**
     * @param solver which one
     * @return the setting that comes nearest; a run that fails has the cost of its whole duration, as far as that is known
     */
    public Match find(SolverChoice solver) {
        return solver.adaptive() ? byTolerance(solver) : byStep(solver);
    }

    /** Whole numbers of steps: the cost of a step changes little with their number, so that proportion finds it. */
    private Match byStep(SolverChoice solver) {
        long steps = Math.max(1, Math.round(target / 4.0));
        Optional<Match> best = Optional.empty();
        for (int trial = 0; trial < TRIALS; trial++) {
            Match match = measure(new Setting(solver, duration / steps, Optional.empty()), steps);
            best = better(best, match);
            long next = Math.max(1, Math.round(target / match.aStep()));
            if (next == steps || Math.abs(match.evaluations() - target) < match.aStep() / 2) {
                break;
            }
            steps = next;
        }
        return best.orElseThrow();
    }

    /** The cost falls with the tolerance, in steps: bisection of its exponent. */
    private Match byTolerance(SolverChoice solver) {
        double loose = Math.log10(LOOSEST);
        double tight = Math.log10(TIGHTEST);
        Optional<Match> best = Optional.empty();
        for (int trial = 0; trial < TRIALS; trial++) {
            double middle = (loose + tight) / 2;
            Match match = measure(new Setting(solver, duration / ADAPTIVE_STEPS, Optional.of(StrictMath.pow(10, middle))), 0);
            best = better(best, match);
            if (match.evaluations() == target) {
                break;
            }
            if (match.evaluations() < target) {
                loose = middle;
            } else {
                tight = middle;
            }
        }
        return best.orElseThrow();
    }

    private Optional<Match> better(Optional<Match> best, Match match) {
        boolean nearer = best.isEmpty() || Math.abs(match.evaluations() - target) < Math.abs(best.get().evaluations() - target);
        return nearer ? Optional.of(match) : best;
    }

    private Match measure(Setting setting, long steps) {
        Outcome outcome = SceneRun.run(SceneRun.build(scene, setting, duration), 20 * target + 1000, List.of());
        double part = Math.max(outcome.endTime() / duration, 1e-9);
        long whole = outcome.failure().isEmpty() ? outcome.evaluations() : Math.round(outcome.evaluations() / part);
        double made = steps == 0 ? outcome.steps() : outcome.failure().isEmpty() ? steps : Math.max(1, outcome.steps());
        return new Match(setting, whole, Math.max(1, outcome.evaluations() / Math.max(1, made)));
    }
}
