package particles.experiments.stability;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.Spectrum.Mode;
import particles.law.Particles;
import particles.scene.format.SceneDescription;
import particles.view.DataTable;

/**
 * The longest stable deltaT of each solver for a scene, from the spectrum of its linearised start and the solver's
 * amplification.
 */
public final class SceneStability {
    /**
     * The smallest |lambda| times the duration that counts: less is round-off, or drag that grows with the speed, at
     * rest.
     */
    private static final double SLOWEST = 1e-3;

    /**
     * The limit of one solver.
     *
     * @param solver the solver
     * @param deltaT the longest stable step (s): 0 if every step grows, infinite if none does; of an adaptive solver of
     *               the catalogue, its longest stable sub-step
     * @param growth the growth of the fastest growing mode in a step of the scene's deltaT, as a fraction
     * @param mode   the mode that sets the limit; if every step grows, the one that grows most; empty if none does
     */
    public record Limit(SolverChoice solver, double deltaT, double growth, String mode) {
        private String text() {
            if (deltaT > 0 && deltaT < Double.POSITIVE_INFINITY) {
                return (solver.adaptive() ? "sub-steps of " : "") + Digits.format("%.6g", deltaT);
            }
            return solver.adaptive() && deltaT == 0 ? "-" : StabilityLimit.text(deltaT, growth);
        }
    }

    private SceneStability() {
    }

    /**
     * @param scene    a scene
     * @param spectrum the spectrum of its start, with at least one mode that does not grow by itself
     * @param solvers  the solvers whose limits to find
     * @param progress receives the progress
     * @return a limit for each solver
     */
    public static List<Limit> limits(SceneDescription scene, Spectrum spectrum, List<SolverChoice> solvers,
            ProgressListener progress) {
        Particles particles = atStart(scene).getParticles();
        return progress.onAllCores(solvers, SolverChoice::label, solver -> {
            SpectrumLimit limit = new SpectrumLimit(Amplification.of(solver), spectrum);
            Mode most = limit.growingMost(scene.deltaT());
            double deltaT = limit.deltaT();
            return new Limit(solver, deltaT, limit.factor(most, scene.deltaT()) - 1, deltaT == Double.POSITIVE_INFINITY
                    ? "" : named(deltaT == 0 ? most : limit.deciding(), particles));
        });
    }

    /** @return the spectrum of the scene's start, without modes too slow to be seen in the scene's duration */
    public static Spectrum spectrum(SceneDescription scene) {
        Spectrum all = Spectrum.of(atStart(scene));
        return new Spectrum(all.modes().stream().filter(mode -> mode.size() * scene.duration() > SLOWEST).toList(),
                all.error());
    }

    private static ParticleSystem atStart(SceneDescription scene) {
        return SceneRun.build(scene, Setting.of(SolverChoice.RK4, scene.deltaT())).system();
    }

    /** A mode by the particle that moves most in it. */
    private static String named(Mode mode, Particles particles) {
        double[] shape = mode.shape();
        int most = IntStream.range(0, shape.length / Particles.STRIDE).boxed().max(Comparator.comparingDouble(i -> {
            int x = Particles.STRIDE * i;
            return shape[x] * shape[x] + shape[x + 1] * shape[x + 1] + shape[x + 2] * shape[x + 2];
        })).orElse(0);
        return Digits.format("'%s', |lambda| = %.4g /s", particles.id(most), mode.size());
    }

    /**
     * @param limits the limits of the solvers
     * @param deltaT the scene's step, for which growth is given
     * @return the table: a row for each solver
     */
    public static DataTable table(List<Limit> limits, double deltaT) {
        return DataTable.of("largest-safe-step", "The longest stable deltaT (s), from the equations linearised at the"
                + " scene's start. Growth is given for a step of " + Digits.exact(deltaT) + " s, the scene's deltaT",
                limits, column("solver", limit -> limit.solver().label()),
                column("longest stable deltaT (s)", Limit::text),
                column("mode that sets it", Limit::mode));
    }
}
