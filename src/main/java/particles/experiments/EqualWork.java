package particles.experiments;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import particles.experiments.SceneRun.Outcome;
import particles.experiments.SceneRun.Setting;
import particles.scene.SceneDescription;

/**
 * Finds the step, or for adaptive solvers the tolerance, with which a run of a scene costs as much as another one:
 * in evaluations of the derivative, or in time.
 */
public final class EqualWork {
    private static final int TRIALS = 14;
    private static final double LOOSEST = 0.1;
    private static final double TIGHTEST = 1e-13;
    /** An adaptive solver is given so many steps at most, and for each this many evaluations; sub-steps do the rest. */
    private static final int ADAPTIVE_STEPS = 200;
    private static final int EVALUATIONS_A_STEP = 14;
    private static final int REPEATS = 9;
    /** Java makes code fast while it runs: so long (s), or so many runs, before a time counts. */
    private static final double WARM = 0.3;
    private static final int WARM_RUNS = 200;
    private static final double WARM_TOLERANCE = 1e-3;
    /** A run that takes longer than this needs no repetition for the clock's sake (s). */
    private static final double LONG = 0.2;
    /** Two times of the same run differ by more than this. */
    private static final double CLOCK = 0.02;

    /**
     * @param setting     how to solve
     * @param evaluations what that costs
     * @param seconds     what it takes, the median of several runs, if times are compared (s); NaN if not
     * @param aStep       evaluations, or seconds, in one of its steps, on average
     */
    public record Match(Setting setting, long evaluations, double seconds, double aStep) {
    }

    private final SceneDescription scene;
    private final double duration;
    private final long evaluations;
    private final Optional<ToDoubleFunction<Outcome>> clock;
    private double target;

    /**
     * Equal evaluations.
     *
     * @param scene    what is to run
     * @param duration how long (s)
     * @param target   evaluations of the derivative, 1 or more
     */
    public EqualWork(SceneDescription scene, double duration, long target) {
        this(scene, duration, target, Optional.empty());
    }

    private EqualWork(SceneDescription scene, double duration, long evaluations, Optional<ToDoubleFunction<Outcome>> clock) {
        this.scene = scene;
        this.duration = duration;
        this.evaluations = evaluations;
        this.clock = clock;
        this.target = evaluations;
    }

    /**
     * Equal time: as much as rk4 takes for its evaluations. The first {@link #find} measures that.
     *
     * @param scene       what is to run
     * @param duration    how long (s)
     * @param evaluations of rk4, 4 or more
     * @param clock       says how long a run took (s)
     * @return the search
     */
    static EqualWork ofTime(SceneDescription scene, double duration, long evaluations, ToDoubleFunction<Outcome> clock) {
        EqualWork work = new EqualWork(scene, duration, evaluations, Optional.of(clock));
        long steps = Math.max(1, evaluations / 4);
        Setting rk4 = new Setting(SolverChoice.of("rk4"), duration / steps, Optional.empty());
        work.warmUp(rk4);
        work.target = work.measure(rk4, steps).seconds();
        return work;
    }

    /** @return the cost that is looked for: evaluations, or seconds */
    public double getTarget() {
        return target;
    }

    /**
     * @param solver which one
     * @return the setting that comes nearest; a run that fails has the cost of its whole duration, as far as that is known
     */
    public Match find(SolverChoice solver) {
        if (clock.isPresent()) {
            warmUp(new Setting(solver, duration / Math.max(1, evaluations / 4), Optional.of(WARM_TOLERANCE)));
        }
        return solver.adaptive() ? byTolerance(solver) : byStep(solver);
    }

    /** Whole numbers of steps: the cost of a step changes little with their number, so that proportion finds it. */
    private Match byStep(SolverChoice solver) {
        long steps = Math.max(1, Math.round(evaluations / 4.0));
        Optional<Match> best = Optional.empty();
        for (int trial = 0; trial < TRIALS; trial++) {
            Match match = measure(new Setting(solver, duration / steps, Optional.empty()), steps);
            best = better(best, match);
            long next = Math.max(1, Math.round(target / match.aStep()));
            if (next == steps || isNear(match)) {
                break;
            }
            steps = next;
        }
        return best.orElseThrow();
    }

    private boolean isNear(Match match) {
        return off(match) < (clock.isPresent() ? CLOCK * target : match.aStep() / 2);
    }

    private void warmUp(Setting setting) {
        double seconds = 0;
        for (int k = 0; k < WARM_RUNS && seconds < WARM; k++) {
            seconds += clock.orElseThrow().applyAsDouble(run(setting));
        }
    }

    /** A step is one sub-step at least: where that alone costs too much, the steps are made longer. */
    private Match byTolerance(SolverChoice solver) {
        long steps = Math.max(1, Math.min(ADAPTIVE_STEPS, evaluations / EVALUATIONS_A_STEP));
        Match best = byTolerance(solver, steps);
        while (steps > 1 && cost(best) - target > best.aStep()) {
            steps /= 2;
            best = better(Optional.of(best), byTolerance(solver, steps)).orElseThrow();
        }
        return best;
    }

    /** The cost falls with the tolerance, in steps: bisection of its exponent. */
    private Match byTolerance(SolverChoice solver, long steps) {
        double loose = Math.log10(LOOSEST);
        double tight = Math.log10(TIGHTEST);
        Optional<Match> best = Optional.empty();
        for (int trial = 0; trial < TRIALS; trial++) {
            double middle = (loose + tight) / 2;
            Match match = measure(new Setting(solver, duration / steps, Optional.of(StrictMath.pow(10, middle))), 0);
            best = better(best, match);
            if (off(match) == 0) {
                break;
            }
            if (cost(match) < target) {
                loose = middle;
            } else {
                tight = middle;
            }
        }
        return best.orElseThrow();
    }

    private double cost(Match match) {
        return clock.isPresent() ? match.seconds() : match.evaluations();
    }

    private double off(Match match) {
        return Math.abs(cost(match) - target);
    }

    private Optional<Match> better(Optional<Match> best, Match match) {
        return best.isEmpty() || off(match) < off(best.get()) ? Optional.of(match) : best;
    }

    private Match measure(Setting setting, long steps) {
        Outcome outcome = run(setting);
        double seconds = clock.isPresent() ? median(setting, outcome) : Double.NaN;
        boolean whole = outcome.failure().isEmpty();
        double part = whole ? 1 : Math.max(outcome.endTime() / duration, 1e-9);
        double made = Math.max(1, whole && steps > 0 ? steps : outcome.steps());
        return new Match(setting, Math.round(outcome.evaluations() / part), seconds / part,
                clock.isPresent() ? seconds / made : Math.max(1, outcome.evaluations() / made));
    }

    private double median(Setting setting, Outcome first) {
        double seconds = clock.orElseThrow().applyAsDouble(first);
        if (seconds > LONG) {
            return seconds;
        }
        double[] all = new double[REPEATS];
        for (int k = 0; k < REPEATS; k++) {
            all[k] = clock.orElseThrow().applyAsDouble(run(setting));
        }
        Arrays.sort(all);
        return all[REPEATS / 2];
    }

    private Outcome run(Setting setting) {
        return SceneRun.run(SceneRun.build(scene, setting, duration), 20 * evaluations + 1000, List.of());
    }
}
