package particles.experiments.runs;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.scene.format.SceneDescription;

/**
 * Finds the step, or for adaptive solvers the tolerance, with which a run of a scene costs as many evaluations of the
 * derivative as another one.
 *
 * @param scene         the scene to run, for its duration
 * @param target        the number of evaluations wanted, 1 or more
 * @param adaptiveSteps the numbers of steps to try for an adaptive solver, the best first
 */
public record EqualWork(SceneDescription scene, long target, List<Long> adaptiveSteps) {
    /** A solver that costs this many times the target does not raise the others' share. */
    private static final double MOST_RAISE = 30;
    /** More by this part is no reason to raise the others' share: with contacts a shorter step may cost less. */
    private static final double NEAR = 0.01;
    private static final int TRIALS = 14;
    private static final long FEW = 1000;
    /** The loosest tolerance that makes sense. */
    private static final double LOOSEST = 0.1;
    /** A solver that fails with a loose tolerance, or is slow with it, may do with a tighter one down to this. */
    private static final double LEAST_LOOSE = 1e-4;
    private static final double TIGHTEST = 1e-13;
    /**
     * The largest number of steps of an adaptive solver, and the evaluations for each; it divides them into sub-steps.
     */
    private static final int ADAPTIVE_STEPS = 200;
    private static final int EVALUATIONS_A_STEP = 14;
    /** Other numbers of steps differ from the best one by at most this factor. */
    private static final long FAR = 4;
    private static final int CANDIDATES = 6;
    private static final double SHORTER = 1.5;

    /**
     * @param setting     the solver and its step or tolerance
     * @param evaluations the cost, in evaluations of the derivative
     * @param steps       the number of its steps
     * @param aStep       the mean number of evaluations in one of its steps
     * @param whole       whether the run came to its end; if not, its cost is that of the whole duration by proportion
     */
    public record Match(Setting setting, long evaluations, long steps, double aStep, boolean whole) {
    }

    /**
     * The shares of several solvers.
     *
     * @param matches the setting of each solver
     * @param work    the evaluations that each was to cost
     * @param slowest the solver that cannot do with less, if that is more than was asked for
     */
    public record Shares(List<Match> matches, long work, Optional<SolverChoice> slowest) {
    }

    /**
     * @param scene  the scene to run, for its duration
     * @param target the number of evaluations wanted, 1 or more
     */
    public EqualWork(SceneDescription scene, long target) {
        this(scene, target, List.of(adaptiveSteps(target)));
    }

    /**
     * Creates a search for runs that are compared at regular times; the steps of an adaptive solver end at these times.
     *
     * @param scene  the scene to run, for its duration
     * @param target the number of evaluations wanted, 1 or more
     * @param frames the number of parts into which the duration is divided, 1 or more
     * @return the search
     */
    public static EqualWork ofFrames(SceneDescription scene, long target, int frames) {
        long best = adaptiveSteps(target);
        List<Long> divisors = LongStream.rangeClosed(1, frames)
                .filter(d -> frames % d == 0 && FAR * d >= best && d <= FAR * best).boxed()
                .sorted(Comparator.comparingDouble(d -> Math.abs(StrictMath.log((double) d / best)))).limit(CANDIDATES)
                .toList();
        return new EqualWork(scene, target, divisors.isEmpty() ? List.of((long) frames) : divisors);
    }

    private static long adaptiveSteps(long target) {
        return Math.max(1, Math.min(ADAPTIVE_STEPS, target / EVALUATIONS_A_STEP));
    }

    /**
     * Finds the setting of a solver that costs the target. A step of an adaptive solver is at least one sub-step; if
     * that alone costs too much, the steps are made longer.
     *
     * @param solver the solver
     * @return the setting that comes nearest
     */
    public Match find(SolverChoice solver) {
        if (!solver.adaptive()) {
            return byStep(solver, target);
        }
        long steps = adaptiveSteps.get(0);
        Match best = byTolerance(solver, steps, target);
        while (steps > 1 && best.evaluations() - target > best.aStep()) {
            steps /= 2;
            best = better(best, byTolerance(solver, steps, target), target);
        }
        return best;
    }

    /**
     * Finds the setting with a wanted cost. An adaptive solver's steps keep their length, so that results are equally
     * dense at any tolerance; other lengths are tried if its cost jumps over the wanted one from one tolerance to the
     * next.
     *
     * @param solver the solver
     * @param wanted evaluations, 1 or more
     * @return the setting with the nearest cost; for an implicit solver one whose run reaches its end, if there is one
     */
    private Match find(SolverChoice solver, long wanted) {
        if (!solver.adaptive()) {
            Match match = byStep(solver, wanted);
            return match.whole() || !solver.implicit() ? match : shortened(match);
        }
        Match best = byTolerance(solver, adaptiveSteps.get(0), wanted);
        boolean least = best.evaluations() > wanted && best.setting().tolerance().equals(Optional.of(LOOSEST));
        for (int k = 1; k < adaptiveSteps.size() && !least && off(best, wanted) >= best.aStep(); k++) {
            best = better(best, byTolerance(solver, adaptiveSteps.get(k), wanted), wanted);
        }
        return best;
    }

    /**
     * About the cheapest run that reaches its end: steps too long for Newton's method are shortened until it converges.
     */
    private Match shortened(Match match) {
        long steps = Math.round(scene.duration() / match.setting().deltaT());
        long most = Math.round(MOST_RAISE * target) + FEW;
        for (int trial = 0; trial < TRIALS; trial++) {
            steps = Math.max(steps + 1, Math.round(SHORTER * steps));
            Match next = measure(Setting.of(match.setting().solver(), scene.duration() / steps), most);
            if (next.whole()) {
                return next;
            }
        }
        return match;
    }

    /**
     * Shares the work among solvers. If a solver needs more work than the target, all get that much, and the others
     * make smaller steps.
     *
     * @param solvers  the solvers that take part
     * @param progress receives the progress
     * @return their shares
     */
    public Shares share(List<SolverChoice> solvers, ProgressListener progress) {
        Optional<Match> slowest = Optional.empty();
        double left = 1;
        for (int round = 1; ; round++) {
            Optional<Match> fixed = slowest;
            long least = fixed.map(Match::evaluations).orElse(target);
            // there may be more rounds, each with half of what is left
            List<Match> matches = progress.part(1 - left, 1 - left / 2).onAllCores(solvers, solver ->
                    "equal work for " + solver.label(), solver -> fixed.filter(match -> match.setting().solver()
                    .equals(solver)).orElseGet(() -> find(solver, least)));
            left /= 2;
            double most = MOST_RAISE * target;
            Optional<Match> over = matches.stream().filter(match -> match.whole() && match.evaluations() <= most
                    && match.evaluations() - least >= Math.max(match.aStep(), NEAR * least))
                    .max(Comparator.comparingLong(Match::evaluations));
            if (over.isEmpty() || round == TRIALS) {
                return new Shares(matches, least, slowest.map(match -> match.setting().solver()));
            }
            slowest = over;
        }
    }

    /** Searches over the number of steps: the cost of a step changes little, so proportion finds the number. */
    private Match byStep(SolverChoice solver, long wanted) {
        long steps = Math.max(1, Math.round(wanted / 4.0));
        long most = Math.round(MOST_RAISE * wanted) + FEW;
        Match match = measure(Setting.of(solver, scene.duration() / steps), most);
        Match best = match;
        for (int trial = 1; trial < TRIALS && off(match, wanted) >= match.aStep() / 2; trial++) {
            long next = Math.max(1, Math.round(wanted / match.aStep()));
            if (next == steps) {
                break;
            }
            steps = next;
            match = measure(Setting.of(solver, scene.duration() / steps), most);
            best = better(best, match, wanted);
        }
        return best;
    }

    /**
     * Searches over the tolerance by bisection of its exponent, if the loosest one does not cost too much.
     */
    private Match byTolerance(SolverChoice solver, long steps, long wanted) {
        long most = Math.round(MOST_RAISE * wanted) + FEW;
        double first = LOOSEST;
        Match best = measure(setting(solver, steps, first), most);
        while (!best.whole() && first > 2 * LEAST_LOOSE) {
            first /= 10;
            best = measure(setting(solver, steps, first), most);
        }
        double loose = StrictMath.log10(first);
        double tight = StrictMath.log10(TIGHTEST);
        boolean cheap = best.evaluations() < wanted;
        for (int trial = 1; trial < TRIALS && cheap && off(best, wanted) > best.aStep() / 4; trial++) {
            double middle = (loose + tight) / 2;
            // that a run costs more than twice as much is enough to know
            Match match = measure(setting(solver, steps, StrictMath.pow(10, middle)), 2 * wanted + FEW);
            best = better(best, match, wanted);
            if (match.evaluations() < wanted) {
                loose = middle;
            } else {
                tight = middle;
            }
        }
        return best;
    }

    private Setting setting(SolverChoice solver, long steps, double tolerance) {
        return new Setting(solver, scene.duration() / steps, Optional.of(tolerance));
    }

    private static double off(Match match, long wanted) {
        return Math.abs(match.evaluations() - wanted);
    }

    /** A run that fails in its first step does not show what a step costs: any other is better. */
    private static Match better(Match best, Match match, long wanted) {
        return (match.steps() > 0 == best.steps() > 0 ? off(match, wanted) < off(best, wanted) : match.steps() > 0)
                ? match : best;
    }

    /** @param most the number of evaluations at which the run is given up */
    private Match measure(Setting setting, long most) {
        Outcome outcome = SceneRun.run(SceneRun.build(scene, setting), most, List.of());
        double part = outcome.whole() ? 1
                : Math.max(outcome.endTime(), Math.min(setting.deltaT(), scene.duration())) / scene.duration();
        return new Match(setting, Math.round(outcome.evaluations() / part), outcome.steps(),
                Math.max(1, outcome.evaluations() / Math.max(1.0, outcome.steps())), outcome.whole());
    }
}
