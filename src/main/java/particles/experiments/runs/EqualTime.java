package particles.experiments.runs;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import particles.experiments.runs.EqualWork.Match;
import particles.experiments.runs.EqualWork.Shares;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.scene.Scene;
import particles.scene.format.SceneDescription;

/**
 * Finds the steps and tolerances with which runs of a scene take the same time: as long as rk4 at the scene's step, or
 * as long as the slowest at its cheapest. Times decide only how many evaluations each solver is to make; the setting
 * that makes them is found by counting. The solvers run in turn, so that other work on the machine slows
 * all of them alike.
 */
public final class EqualTime {
    /** Times that differ by less than this fraction count as equal. */
    public static final double CLOSE = 0.08;
    private static final int ROUNDS = 8;
    /** A setting that makes more evaluations than were wanted, by this part, is one that cannot do with less. */
    private static final double OVER = 0.05;
    private static final int REPEATS = 61;
    private static final int FEWEST_REPEATS = 3;
    /** So long (s) are all runs repeated, but not less often than the fewest times, unless that takes very long. */
    private static final double ENOUGH = 1.5;
    private static final double LONG = 4;
    /** After so long (s) of measured runs no further round begins. */
    private static final double PATIENCE = 20;
    /** Java makes code fast while it runs: so long (s), or so many runs of each, before a time counts. */
    private static final double WARM = 0.3;
    private static final int WARM_RUNS = 200;
    /** Runs that make so many times the evaluations that were counted before are given up. */
    private static final long MOST = 100;

    private final SceneDescription scene;
    private final EqualWork work;
    private final ToDoubleFunction<Outcome> clock;
    private final Setting rk4;
    private final long evaluations;
    private double spent;

    /**
     * @param scene       what is to run, for its duration
     * @param evaluations of rk4 in the run that all are to last as long as, 4 or more
     * @param frames      into how many parts the duration is divided, 1 or more
     * @param clock       says how long a run took (s)
     */
    public EqualTime(SceneDescription scene, long evaluations, int frames, ToDoubleFunction<Outcome> clock) {
        this.scene = scene;
        this.evaluations = evaluations;
        this.clock = clock;
        work = EqualWork.ofFrames(scene, evaluations, frames);
        rk4 = new Setting(SolverChoice.of("rk4"), scene.duration() / Math.max(1, evaluations / 4), Optional.empty());
    }

    /**
     * @param solvers  who takes part
     * @param progress hears how far it is
     * @return the shares, of all rounds those whose times differ least
     */
    public Shares share(List<SolverChoice> solvers, ProgressListener progress) {
        List<Entrant> entrants = new ArrayList<>();
        spent = 0;
        for (SolverChoice solver : solvers) {
            progress.reached(0.3 * entrants.size() / solvers.size(), "a first guess for " + solver.label());
            entrants.add(new Entrant(solver));
            warmUp(entrants.get(entrants.size() - 1));
        }
        Optional<Shares> best = Optional.empty();
        for (int round = 0; round < ROUNDS; round++) {
            progress.reached(0.3 + 0.7 * round / ROUNDS, "equal time, round " + (round + 1));
            double target = time(entrants);
            double most = EqualWork.MOST_RAISE * target;
            Optional<SolverChoice> slowest = Optional.empty();
            for (Entrant entrant : entrants) {
                double least = entrant.leastSeconds();
                if (least > target && least <= most) {
                    target = least;
                    slowest = Optional.of(entrant.solver);
                }
            }
            Shares shares = new Shares(entrants.stream().map(Entrant::timed).toList(), target, slowest);
            if (best.isEmpty() || spread(shares) < spread(best.get())) {
                best = Optional.of(shares);
            }
            if (spread(shares) < CLOSE || spent > PATIENCE) {
                break;
            }
            for (Entrant entrant : entrants) {
                entrant.aimAt(target);
            }
        }
        return best.orElseThrow();
    }

    /**
     * @param shares with seconds
     * @return by which part the longest time exceeds the shortest, the one that was aimed at among them
     */
    public static double spread(Shares shares) {
        double[] seconds = shares.matches().stream().mapToDouble(match -> match.seconds().orElseThrow()).toArray();
        return Math.max(shares.work(), Arrays.stream(seconds).max().orElse(0))
                / Math.min(shares.work(), Arrays.stream(seconds).min().orElse(shares.work())) - 1;
    }

    private static void warmUp(Entrant entrant) {
        double seconds = 0;
        for (int k = 0; k < WARM_RUNS && seconds < WARM; k++) {
            seconds += entrant.run();
        }
    }

    /**
     * Runs everybody in turn, and rk4 at the scene's step after them.
     *
     * @return the median time of rk4 (s)
     */
    private double time(List<Entrant> entrants) {
        List<Double> times = new ArrayList<>();
        entrants.forEach(entrant -> entrant.times.clear());
        double all = 0;
        for (int k = 0; k < REPEATS && all < (k < FEWEST_REPEATS ? LONG : ENOUGH); k++) {
            for (Entrant entrant : entrants) {
                all += entrant.run();
            }
            times.add(clock.applyAsDouble(run(rk4, MOST * evaluations)));
            all += times.get(k);
        }
        spent += all;
        return median(times);
    }

    /** In one thread, as long as nobody hands in more, so that no time is spent waiting for others. */
    private Outcome run(Setting setting, long mostEvaluations) {
        Scene built = SceneRun.build(scene, setting, scene.duration());
        return SceneRun.run(built, mostEvaluations, List.of());
    }

    private static double median(List<Double> times) {
        double[] sorted = times.stream().mapToDouble(time -> time).sorted().toArray();
        return sorted[sorted.length / 2];
    }

    /** A solver, its setting so far, and the times of its runs. */
    private final class Entrant {
        private final SolverChoice solver;
        private final double loosest;
        private final List<Double> times = new ArrayList<>();
        private Match match;
        /** Whether this is its cheapest setting. */
        private boolean atLeast;
        /** How long its cheapest setting took, if it was met; 0 if not (s). */
        private double leastSeconds;

        Entrant(SolverChoice solver) {
            this.solver = solver;
            loosest = solver.adaptive() ? cheapest() : EqualWork.LOOSEST;
            find(evaluations);
        }

        /**
         * With a looser tolerance an implicit solver may evaluate less and yet take longer: its iterations get long.
         */
        private double cheapest() {
            double best = EqualWork.LOOSEST;
            seconds(best, WARM_RUNS, WARM);
            double least = seconds(best, FEWEST_REPEATS, WARM);
            for (double next = best / 10; next > 0.5 * EqualWork.LEAST_LOOSE; next /= 10) {
                double seconds = seconds(next, FEWEST_REPEATS, WARM);
                if (seconds < least) {
                    best = next;
                    least = seconds;
                } else if (Double.isFinite(least)) {
                    break;
                }
            }
            return best;
        }

        /**
         * @return the median of so many runs, or of fewer when they take long enough (s); infinite for a run that fails
         */
        private double seconds(double tolerance, int repeats, double enough) {
            List<Double> some = new ArrayList<>();
            for (double all = 0; some.size() < repeats && all < enough; all += some.get(some.size() - 1)) {
                Outcome outcome = EqualTime.this.run(work.setting(solver, tolerance), MOST * evaluations);
                some.add(outcome.failure().isEmpty() ? clock.applyAsDouble(outcome) : Double.POSITIVE_INFINITY);
            }
            return median(some);
        }

        private void find(long wanted) {
            match = work.find(solver, loosest, wanted);
            atLeast = match.whole() && match.evaluations() > (1 + OVER) * wanted;
        }

        /** @return how long it took (s) */
        double run() {
            Outcome outcome = EqualTime.this.run(match.setting(), MOST * match.evaluations());
            double seconds = clock.applyAsDouble(outcome);
            times.add(seconds * match.evaluations() / Math.max(1, outcome.evaluations()));
            return seconds;
        }

        /** @return the least time that is known to be needed; 0 if it is not known (s) */
        double leastSeconds() {
            leastSeconds = atLeast ? median(times) : leastSeconds;
            return leastSeconds;
        }

        void aimAt(double target) {
            find(Math.max(1, Math.round(match.evaluations() * target / median(times))));
        }

        Match timed() {
            return new Match(match.setting(), match.evaluations(), OptionalDouble.of(median(times)), match.aStep(),
                    match.whole());
        }
    }
}
