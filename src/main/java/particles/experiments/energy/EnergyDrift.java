package particles.experiments.energy;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import particles.Observer;
import particles.energy.EnergyHistory;
import particles.energy.EnergyRecorder;
import particles.experiments.runs.FittedLine;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.scene.Scene;
import particles.scene.format.SceneDescription;
import particles.view.Look;

/**
 * Compares the energy drift of solvers on a scene. The drift is the energy ledger's numerical error - the change that
 * neither drag nor bounces nor any other work explains - relative to the largest energy of an accurate run.
 */
public final class EnergyDrift {
    /** Enough for the size of the energy to six digits; a tighter one takes most of the time on a stiff cloth. */
    private static final double REFERENCE_TOLERANCE = 1e-6;

    /**
     * The energy drift of one solver's run.
     *
     * @param setting the solver and its step
     * @param time    the times of the errors (s)
     * @param error   the numerical error at these times, divided by the energy scale
     * @param outcome the outcome of the run
     */
    public record Drift(Setting setting, double[] time, double[] error, Outcome outcome) {

        /** @return the solver's name in charts */
        public String label() {
            return setting.label();
        }

        /** @return the solver's look in charts */
        public Look look() {
            return setting.solver().look();
        }

        /** @return the last error */
        public double end() {
            return error[error.length - 1];
        }

        /** @return the slope of the straight line through all errors (1/s) */
        public double slope() {
            return FittedLine.slope(time, error);
        }

        /** @return the error of the largest size, with its sign: above 0 if energy was gained */
        public double extreme() {
            return Arrays.stream(error).boxed().max(Comparator.comparingDouble(Math::abs)).orElse(0.0);
        }
    }

    /**
     * The energy drift of all solvers compared.
     *
     * @param scale  the energy scale by which errors were divided (J)
     * @param drifts the result of each solver
     */
    public record Comparison(double scale, List<Drift> drifts) {
    }

    private EnergyDrift() {
    }

    /**
     * @param scene    a scene, with the step and duration that are wanted
     * @param solvers  the solvers to compare
     * @param progress receives the progress
     * @return the runs
     */
    public static Comparison compare(SceneDescription scene, List<SolverChoice> solvers, ProgressListener progress) {
        progress.reached(0, "the energy scale");
        double scale = scale(scene);
        // measured: the scale takes nearly half of the time
        return new Comparison(scale, progress.part(0.45, 1).onAllCores(solvers, SolverChoice::label,
                solver -> {
                    Setting setting = Setting.of(solver, scene.deltaT());
                    return measure(SceneRun.build(scene, setting), setting, scale, List.of());
                }));
    }

    /** @param beside further observers, called after the energy is recorded */
    public static Drift measure(Scene built, Setting setting, double scale, List<? extends Observer> beside) {
        EnergyRecorder energy = new EnergyRecorder(built.simulation(), built.energyEstimate(), 1);
        energy.attachTo(built.simulation(), beside);
        Outcome outcome = SceneRun.run(built, List.of());
        double[][] errors = energy.getLedger().getNumericalErrors();
        double[] error = Arrays.stream(errors[1]).takeWhile(Double::isFinite).map(joules -> joules / scale).toArray();
        return new Drift(setting, Arrays.copyOf(errors[0], error.length), error, outcome);
    }

    /** The largest kinetic plus stored energy of a very accurate run, as far as it came. */
    private static double scale(SceneDescription scene) {
        EnergyHistory history = new EnergyHistory();
        Scene reference = SceneRun.build(scene, Setting.accurate(scene.deltaT(), REFERENCE_TOLERANCE));
        SceneRun.run(reference, List.of(history));
        return history.getScaleOr(reference.energyEstimate());
    }
}
