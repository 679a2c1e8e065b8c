package particles.experiments.runs;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import particles.experiments.runs.EqualWork.Match;
import particles.experiments.runs.EqualWork.Shares;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.scene.format.SceneDescription;

/**
 * Finds the steps and tolerances with which runs of a scene take the same time: as long as rk4 at the scene's step, or
 * as long as the slowest at its cheapest. Times only set the number of evaluations that each solver should make; the
 * setting with this number is found by counting. The solvers run in turn, so that other work on the machine slows all
 * of them alike.
 */
public final class EqualTime {
    /** Times that differ by less than this fraction count as equal. */
    public static final double CLOSE = 0.08;
    private static final int ROUNDS = 8;
    /** A setting with more evaluations than wanted, by this fraction, counts as the cheapest possible. */
    private static final double OVER = 0.05;
    private static final int REPEATS = 61;
    private static final int FEWEST_REPEATS = 3;
    /** Runs are repeated for this time (s), and at least the fewest times unless that takes very long. */
    private static final double ENOUGH = 1.5;
    private static final double LONG = 4;
    /** After this time (s) of measured runs no further round begins. */
    private static final double PATIENCE = 20;
    /**
     * The time of warm-up (s), up to a number of runs of each, before a time counts: Java compiles code while it runs.
     */
    private static final double WARM = 0.3;
    private static final int WARM_RUNS = 200;
    /** Runs that make this many times the evaluations counted before are given up. */
    private static final long MOST = 100;

    private final SceneDescription scene;
    private final EqualWork work;
    private final ToDoubleFunction<Outcome> clock;
    private final Setting rk4;
    private final long evaluations;
    private double spent;

    /**
     * @param scene       the scene to run, for its duration
     * @param evaluations the number of evaluations of the rk4 run whose time all should take, 4 or more
     * @param frames      the number of parts into which the duration is divided, 1 or more
     * @param clock       measures the time of a run (s)
     */
    public EqualTime(SceneDescription scene, long evaluations, int frames, ToDoubleFunction<Outcome> clock) {
        this.scene = scene;
        this.evaluations = evaluations;
        this.clock = clock;
        work = EqualWork.ofFrames(scene, evaluations, frames);
        rk4 = Setting.of(SolverChoice.RK4, scene.duration() / Math.max(1, evaluations / 4));
    }

    /**
     * @param solvers  the solvers that take part
     * @param progress receives the progress
     * @return the shares of the round whose times differ least
     */
    public Shares share(List<SolverChoice> solvers, ProgressListener progress) {
        List<Entrant> entrants = new ArrayList<>();
        spent = 0;
        for (SolverChoice solver : solvers) {
            progress.reached(0.3 * entrants.size() / solvers.size(), "a first guess for " + solver.label());
            entrants.add(new Entrant(solver));
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
     * @param shares the shares, with times
     * @return the fraction by which the longest time exceeds the shortest; the time aimed at counts too
     */
    public static double spread(Shares shares) {
        DoubleSummaryStatistics seconds = shares.matches().stream().filter(Match::whole)
                .mapToDouble(Match::seconds).summaryStatistics();
        return Math.max(shares.work(), seconds.getMax()) / Math.min(shares.work(), seconds.getMin()) - 1;
    }

    /**
     * Runs all solvers in turn, and rk4 at the scene's step after them.
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
            Outcome pace = run(rk4, MOST * evaluations);
            double seconds = clock.applyAsDouble(pace);
            // a run that fails counts as if it had come to its end
            times.add(seconds * (pace.whole() ? 1 : evaluations / Math.max(1.0, pace.evaluations())));
            all += seconds;
        }
        spent += all;
        return CpuClock.median(times);
    }

    /** Runs in one thread, so that no time is spent waiting for others. */
    private Outcome run(Setting setting, long mostEvaluations) {
        return SceneRun.run(SceneRun.build(scene, setting), mostEvaluations, List.of());
    }

    /** A solver, its setting so far, and the times of its runs. */
    private final class Entrant {
        private final SolverChoice solver;
        private final double loosest;
        private final List<Double> times = new ArrayList<>();
        private Match match;
        /** Whether this is its cheapest setting. */
        private boolean atLeast;
        /** The time of its cheapest setting (s); 0 if it was not measured. */
        private double leastSeconds;

        Entrant(SolverChoice solver) {
            this.solver = solver;
            loosest = solver.adaptive() ? cheapest() : EqualWork.LOOSEST;
            find(evaluations);
            seconds(match.setting(), WARM_RUNS);
        }

        /**
         * Finds the tolerance with the shortest time. With a looser tolerance an implicit solver may evaluate less and
         * yet take longer, since it needs more iterations.
         */
        private double cheapest() {
            double best = EqualWork.LOOSEST;
            seconds(work.setting(solver, best), WARM_RUNS);
            double least = seconds(work.setting(solver, best), FEWEST_REPEATS);
            for (double next = best / 10; next > 0.5 * EqualWork.LEAST_LOOSE; next /= 10) {
                double seconds = seconds(work.setting(solver, next), FEWEST_REPEATS);
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
         * @return the median time of this number of runs (s), or of fewer if they take long enough; infinite if a run
         *         fails
         */
        private double seconds(Setting setting, int repeats) {
            List<Double> some = new ArrayList<>();
            for (double all = 0; some.size() < repeats && all < WARM; all += some.get(some.size() - 1)) {
                Outcome outcome = EqualTime.this.run(setting, MOST * evaluations);
                some.add(outcome.whole() ? clock.applyAsDouble(outcome) : Double.POSITIVE_INFINITY);
            }
            return CpuClock.median(some);
        }

        private void find(long wanted) {
            match = work.find(solver, loosest, wanted);
            atLeast = match.whole() && match.evaluations() > (1 + OVER) * wanted;
        }

        /** @return its time (s) */
        double run() {
            Outcome outcome = EqualTime.this.run(match.setting(), MOST * match.evaluations());
            double seconds = clock.applyAsDouble(outcome);
            times.add(seconds * match.evaluations() / Math.max(1, outcome.evaluations()));
            return seconds;
        }

        /** @return the least time that is known to be needed; 0 if it is not known (s) */
        double leastSeconds() {
            leastSeconds = atLeast ? CpuClock.median(times) : leastSeconds;
            return leastSeconds;
        }

        void aimAt(double target) {
            find(Math.max(1, Math.round(match.evaluations() * target / CpuClock.median(times))));
        }

        Match timed() {
            return new Match(match.setting(), match.evaluations(), CpuClock.median(times), match.steps(), match.aStep(),
                    match.whole());
        }
    }
}
