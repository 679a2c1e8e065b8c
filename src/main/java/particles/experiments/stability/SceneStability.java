package particles.experiments.stability;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.PerturbationGrowth.Twins;
import particles.experiments.stability.Spectrum.Mode;
import particles.law.Particles;
import particles.scene.format.SceneDescription;
import particles.view.DataTable;

/**
 * The largest safe deltaT of each solver for a scene: predicted from the spectrum of its linearised start and the
 * solver's amplification, and found by bisection on pairs of runs of the whole scene.
 */
public final class SceneStability {
    private static final double BRACKET = 1.25;
    private static final int MOST_BRACKETS = 60;
    /** Safe at 1.25^10 times the first guess: the modes of the start do not limit the step, and runs get long. */
    private static final int MOST_LONGER = 9;
    private static final double ACCURACY = 2e-3;
    /** Without a predicted limit, a few steps of this many times 2/|lambda| are tried. */
    private static final double FAR = 900;
    private static final int FAR_STEPS = 4;
    private static final double FAR_FACTOR = 30;
    private static final long MOST_EVALUATIONS = 100_000;
    /**
     * An adaptive solver divides steps that are too long: this many times the scene's own deltaT are enough to see
     * that.
     */
    private static final double ADAPTIVE_TIMES = 10;
    /**
     * The smallest |lambda| times the duration that counts: less is round-off, or drag that grows with the speed, at
     * rest.
     */
    private static final double SLOWEST = 1e-3;
    /** If the measured limit differs from the predicted one by this factor, it is not set by the modes of the start. */
    private static final double FAR_OFF = 1.5;
    /** Beyond this relative difference, the measured limit is that of a motion that is not small. */
    private static final double NEARLY = 0.01;
    private static final String LEAVES_LINEAR = "; the prediction holds for small motions only";
    private static final String LEAVES_MODES = "the motion soon leaves the modes of its start";
    /** The part of the rk4 limit at which twins show the effect of the motion itself on a distance. */
    private static final double FINE = 0.5;
    private static final double RK4 = 2.8284;
    /** A tolerance that changes a distance of a ten-millionth by far less than a growth that matters. */
    private static final double EXACT = 1e-13;

    private final SceneDescription scene;
    private final Spectrum spectrum;
    private final Particles particles;
    private final PerturbationGrowth twins;
    private final Map<Mode, Twins> fine = new HashMap<>();

    /**
     * The result for one solver.
     *
     * @param solver    the solver
     * @param predicted the longest safe step by theory (s): 0 if every step grows, infinite if none does, of an
     *                  adaptive solver its longest sub-step; NaN for a solver that is not in the catalogue
     * @param measured  the longest safe step on runs (s): 0 if the scene's deltaT and shorter ones grow,
     *                  infinite if no step grew; NaN if a run with a very long step failed
     * @param predictedGrowth the theoretical growth of the distance in a step of the scene's deltaT, as a fraction
     * @param measuredGrowth  the measured growth, as a fraction
     * @param note      the reason why longer steps are not safe, or the longest step tried
     */
    public record Limit(SolverChoice solver, double predicted, double measured, double predictedGrowth,
            double measuredGrowth, String note) {
        /** @return whether it was predicted and measured that steps up to a limit are safe */
        public boolean isFinite() {
            return isFinite(measured) && isFinite(predicted) && !solver.adaptive();
        }

        /** @return whether it was predicted that any step is safe, or the solver divides those that are too long */
        boolean isUnlimited() {
            return predicted == Double.POSITIVE_INFINITY || solver.adaptive();
        }

        /** @return whether there is a longest safe step (s), and not none, any, or one that is not known */
        public static boolean isFinite(double step) {
            return step > 0 && step < Double.POSITIVE_INFINITY;
        }
    }

    private SceneStability(SceneDescription scene, Spectrum spectrum) {
        this.scene = scene;
        this.spectrum = spectrum;
        particles = atStart(scene).getParticles();
        twins = new PerturbationGrowth(scene);
    }

    /**
     * @param scene    a scene
     * @param spectrum the spectrum of its start, with at least one mode that does not grow by itself
     * @param solvers  the solvers whose limits to find
     * @param progress receives the progress
     * @return a limit for each solver
     */
    public static List<Limit> measure(SceneDescription scene, Spectrum spectrum, List<SolverChoice> solvers,
            ProgressListener progress) {
        SceneStability stability = new SceneStability(scene, spectrum);
        // each run is a system of its own, so that solvers share nothing but the fine runs, which do not depend on who
        // asks first
        return progress.onAllCores(solvers, solver -> "found the largest safe step of " + solver.label(),
                stability::limit);
    }

    /** @return the spectrum of the scene's start, without modes too slow to be seen in the scene's duration */
    public static Spectrum spectrum(SceneDescription scene) {
        Spectrum all = Spectrum.of(atStart(scene));
        return new Spectrum(all.modes().stream().filter(mode -> mode.size() * scene.duration() > SLOWEST).toList(),
                all.products(), all.error());
    }

    private static ParticleSystem atStart(SceneDescription scene) {
        return SceneRun.build(scene, Setting.of(SolverChoice.RK4, scene.deltaT()), scene.deltaT()).system();
    }

    private Limit limit(SolverChoice solver) {
        Mode fastest = spectrum.decaying().get(0);
        if (solver.info().isEmpty()) {
            return bisected(solver, Double.NaN, 2 / fastest.size(), fastest);
        }
        SpectrumLimit theory = new SpectrumLimit(solver.info().get(), spectrum);
        double predicted = theory.deltaT();
        Mode most = theory.growingMost(scene.deltaT());
        double growth = theory.factor(most, scene.deltaT()) - 1;
        if (solver.adaptive() || predicted == Double.POSITIVE_INFINITY) {
            return farOut(solver, predicted, growth, fastest);
        }
        if (predicted > 0) {
            return bisected(solver, predicted, predicted, theory.deciding());
        }
        Twins pair = twins.run(Setting.of(solver, scene.deltaT()), most, PerturbationGrowth.STEPS);
        double measured = pair.factor(twins.run(Setting.accurate(scene.deltaT(), EXACT), most,
                PerturbationGrowth.STEPS)) - 1;
        boolean leaves = growth > StabilityLimit.ROUND_OFF && measured * FAR_OFF < growth;
        return new Limit(solver, 0, 0, growth, measured,
                (leaves ? LEAVES_MODES + ", where " : "") + named(most) + " grows most");
    }

    private Limit bisected(SolverChoice solver, double predicted, double start, Mode mode) {
        double safe = start / BRACKET;
        double unsafe = start * BRACKET;
        for (int n = 0; !isSafe(solver, safe, mode); n++) {
            unsafe = safe;
            safe /= BRACKET;
            if (n == MOST_BRACKETS) {
                return new Limit(solver, predicted, 0, Double.NaN, Double.NaN,
                        Digits.format("grows even at %.3g s", unsafe));
            }
        }
        for (int n = 0; isSafe(solver, unsafe, mode); n++) {
            safe = unsafe;
            unsafe *= BRACKET;
            if (n == MOST_LONGER) {
                return new Limit(solver, predicted, Double.POSITIVE_INFINITY, Double.NaN, Double.NaN,
                        Digits.format("longest tried: %.3g s", safe));
            }
        }
        double measured = StabilityLimit.bisected(safe, unsafe, ACCURACY, deltaT -> isSafe(solver, deltaT, mode))
                * (1 + ACCURACY / 2);
        boolean agree = Math.max(predicted / measured, measured / predicted) < FAR_OFF;
        return new Limit(solver, predicted, measured, Double.NaN, Double.NaN, agree || Double.isNaN(predicted)
                ? "set by " + named(mode) + (Math.abs(measured / predicted - 1) > NEARLY ? LEAVES_LINEAR : "")
                : LEAVES_MODES);
    }

    private boolean isSafe(SolverChoice solver, double deltaT, Mode mode) {
        Twins pair = twins.run(Setting.of(solver, deltaT), mode, PerturbationGrowth.STEPS);
        return pair.failure().isEmpty() && !pair.leaves(fine(mode, PerturbationGrowth.STEPS * deltaT));
    }

    /**
     * Twins that show the effect of the motion itself on a distance, such as the folds of a cloth or a double
     * pendulum's chaos.
     */
    private synchronized Twins fine(Mode mode, double duration) {
        Twins known = fine.get(mode);
        if (known == null || known.duration() < duration) {
            double deltaT = FINE * RK4 / spectrum.modes().get(0).size();
            known = twins.run(Setting.of(SolverChoice.RK4, deltaT), mode,
                    (int) Math.ceil(BRACKET * duration / deltaT));
            fine.put(mode, known);
        }
        return known;
    }

    /**
     * Tries steps far beyond the limit of any explicit method. Only a failing run ends them, since such long steps may
     * be inaccurate.
     */
    private Limit farOut(SolverChoice solver, double predicted, double predictedGrowth, Mode fastest) {
        double unit = 2 / fastest.size();
        double longest = solver.adaptive() ? ADAPTIVE_TIMES * scene.deltaT() : FAR * unit;
        for (double deltaT = solver.adaptive() ? longest : unit; deltaT <= longest * (1 + ACCURACY);
                deltaT *= FAR_FACTOR) {
            Outcome outcome = SceneRun.run(SceneRun.build(scene, Setting.of(solver, deltaT), FAR_STEPS * deltaT),
                    MOST_EVALUATIONS, List.of());
            if (outcome.failure().isPresent()) {
                return new Limit(solver, predicted, Double.NaN, predictedGrowth, Double.NaN,
                        Digits.format("at %.3g s: %s", deltaT, outcome.failure().get()));
            }
        }
        return new Limit(solver, predicted, Double.POSITIVE_INFINITY, predictedGrowth, Double.NaN,
                (solver.adaptive() ? "chooses its own sub-steps; " : "") + "longest tried: " + Digits.few(longest)
                        + " s");
    }

    /** A mode by the particle that moves most in it. */
    private String named(Mode mode) {
        double[] shape = mode.shape();
        int most = IntStream.range(0, shape.length / Particles.STRIDE).boxed().max(Comparator.comparingDouble(i -> {
            int x = Particles.STRIDE * i;
            return shape[x] * shape[x] + shape[x + 1] * shape[x + 1] + shape[x + 2] * shape[x + 2];
        })).orElse(0);
        return Digits.format("the mode of '%s' (|lambda| = %.4g /s)", particles.id(most), mode.size());
    }

    /**
     * @param limits the limits of the solvers
     * @param deltaT the scene's step, at which growth was measured
     * @return the table: a row for each solver
     */
    public static DataTable table(List<Limit> limits, double deltaT) {
        return DataTable.of("largest-safe-step",
                "The largest safe deltaT (s). Predicted: from the equations, linearised at the scene's start. Measured:"
                        + " from runs. 'Always grows' is followed by the growth in a step of " + deltaT + " s,"
                        + " the scene's deltaT", limits, column("solver", limit -> limit.solver().label()),
                column("predicted", SceneStability::predicted),
                column("measured", limit -> limit.measured() == Double.POSITIVE_INFINITY ? limit.isUnlimited()
                        ? "stable" : "no limit found" : text(limit.measured(), limit.measuredGrowth())),
                column("measured/predicted", limit -> limit.isFinite() ? limit.measured() / limit.predicted() : "-"),
                column("remark", Limit::note));
    }

    private static String predicted(Limit limit) {
        if (!limit.solver().adaptive() || limit.predicted() == Double.POSITIVE_INFINITY) {
            return text(limit.predicted(), limit.predictedGrowth());
        }
        return limit.predicted() > 0 ? Digits.format("sub-steps of %.6g", limit.predicted()) : "-";
    }

    private static String text(double value, double growth) {
        if (value == 0) {
            return Double.isNaN(growth) ? "none" : growth > 0 ? StabilityLimit.text(0, growth)
                    : Digits.format("no growth seen in %d steps", PerturbationGrowth.STEPS);
        }
        return Limit.isFinite(value) ? Digits.format("%.6g", value)
                : StabilityLimit.text(value, growth);
    }
}
