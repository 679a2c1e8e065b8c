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
    /** More by this part is no reason to raise the others' share: with contacts a shorter step may cost less. */
    private static final double NEAR = 0.01;
    /** Exponents of the loosest tolerance that makes sense and of the tightest. */
    private static final double LOOSEST = -1;
    private static final double TIGHTEST = -13;
    /** The largest number of steps of an adaptive solver, and the evaluations for each, with its sub-steps. */
    private static final int ADAPTIVE_STEPS = 200;
    private static final int EVALUATIONS_A_STEP = 14;

    /**
     * The setting of a solver.
     *
     * @param setting its step or tolerance
     * @param cost    the evaluations of a run with it
     * @param steps   the number of its steps
     * @param whole   whether that run came to its end; if not, its cost is that of the whole duration by proportion
     */
    public record Match(Setting setting, double cost, long steps, boolean whole) {
        private double off(long target) {
            return steps == 0 ? Double.POSITIVE_INFINITY : Math.abs(cost - target);
        }
    }

    /** The settings of several solvers, and the evaluations that each was to cost. */
    public record Shares(long work, List<Match> matches) {
    }

    /**
     * Shares work among solvers. If one cannot do with the target, all get as much as it needs, and the others make
     * shorter steps.
     *
     * @param solvers  the solvers
     * @param progress receives the progress
     * @return their settings
     */
    public Shares share(List<SolverChoice> solvers, ProgressListener progress) {
        List<Match> matches = find(solvers, progress.part(0, 0.5));
        long most = Math.round(matches.stream().filter(match -> match.whole && match.cost - target
                > Math.max(NEAR * target, match.cost / match.steps)).mapToDouble(Match::cost).max().orElse(target));
        return most == target ? new Shares(target, matches) : new Shares(most,
                new EqualWork(scene, most, frames).find(solvers, progress.part(0.5, 1)));
    }

    private List<Match> find(List<SolverChoice> solvers, ProgressListener progress) {
        return progress.onAllCores(solvers, solver -> "equal work for " + solver.label(), this::find);
    }

    /** @return the setting of a solver whose cost comes nearest */
    Match find(SolverChoice solver) {
        return solver.adaptive() ? byTolerance(solver) : bySteps(solver);
    }

    /** The cost of a step changes little with its length, so proportion finds the number of steps. */
    private Match bySteps(SolverChoice solver) {
        Set<Long> tried = new HashSet<>();
        long steps = Math.max(1, Math.round(target / 4.0));
        Optional<Match> best = Optional.empty();
        while (tried.size() < TRIALS && tried.add(steps)) {
            Match match = measure(Setting.of(solver, scene.duration() / steps));
            best = best.filter(other -> other.off(target) <= match.off(target)).or(() -> Optional.of(match));
            // a first step that fails does not show what a step costs: a shorter one may not fail
            steps = match.steps == 0 ? steps + (steps + 1) / 2
                    : Math.max(1, Math.round(steps * (target / match.cost)));
        }
        return best.orElseThrow();
    }

    /**
     * Bisects the exponent of the tolerance, from the loosest one, which is taken if it already costs too much; a run
     * that fails asks for a tighter one.
     */
    private Match byTolerance(SolverChoice solver) {
        long most = Math.max(1, Math.min(ADAPTIVE_STEPS, target / EVALUATIONS_A_STEP));
        int steps = IntStream.rangeClosed(1, frames).filter(d -> frames % d == 0 && d <= most).max().orElseThrow();
        double loose = LOOSEST;
        double tight = TIGHTEST;
        double exponent = loose;
        Optional<Match> best = Optional.empty();
        for (int trial = 0; trial < TRIALS && tight < loose; trial++) {
            Match match = measure(new Setting(solver, scene.duration() / steps,
                    Optional.of(StrictMath.pow(10, exponent))));
            if (best.isEmpty() || match.whole && (!best.get().whole || match.off(target) < best.get().off(target))) {
                best = Optional.of(match);
            }
            if (match.whole && match.cost >= target) {
                tight = exponent;
            } else {
                loose = exponent;
            }
            exponent = (loose + tight) / 2;
        }
        return best.orElseThrow();
    }

    private Match measure(Setting setting) {
        Outcome outcome = SceneRun.run(SceneRun.build(scene, setting), List.of());
        double part = outcome.whole() || outcome.endTime() == 0 ? 1 : outcome.endTime() / scene.duration();
        return new Match(setting, Math.max(1, outcome.evaluations() / part), outcome.steps(), outcome.whole());
    }
}
