package particles.experiments.stability;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.Spectrum.Mode;
import particles.scene.format.SceneDescription;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * The longest stable deltaT of each solver for a scene: the longest step at which no mode of its linearised start grows
 * that would not grow by itself. It is the smallest limit of all modes, each measured on the solver's real code in the
 * direction of its lambda in the complex plane. Each mode is treated as a separate spring. That is exact for
 * Runge-Kutta and implicit methods, and for symplectic ones if the damping matrix has the modes of the stiffness
 * matrix.
 */
public final class SceneStability {
    /**
     * The smallest |lambda| times the duration that counts: less is round-off, or drag that grows with the speed, at
     * rest.
     */
    private static final double SLOWEST = 1e-3;
    /** Modes whose directions in the plane agree to this share a limit. */
    private static final double SAME_DIRECTION = 1e-7;

    /**
     * The limit of one solver.
     *
     * @param solver the solver
     * @param deltaT the longest stable step (s): 0 if every step grows, infinite if none does; of an adaptive solver of
     *               the catalogue, its longest stable sub-step
     * @param growth the growth of the fastest growing mode in a step of the scene's deltaT, as a fraction
     * @param mode   the mode that sets the limit; if every step grows, the one that grows most; empty if none does, or
     *               of sub-steps without a limit
     */
    public record Limit(SolverChoice solver, double deltaT, double growth, Optional<Mode> mode) {
        private String text() {
            if (deltaT > 0 && deltaT < Double.POSITIVE_INFINITY) {
                return (solver.adaptive() ? "sub-steps of " : "") + Digits.format("%.6g", deltaT);
            }
            return solver.adaptive() && deltaT == 0 ? "-" : new StabilityLimit(deltaT, growth).text();
        }
    }

    private SceneStability() {
    }

    /**
     * @param spectrum the spectrum of a scene's start, with at least one mode that does not grow by itself
     * @param deltaT   the scene's step (s), for which growth is given
     * @param solvers  the solvers whose limits to find
     * @param progress receives the progress
     * @return a limit for each solver
     */
    public static List<Limit> limits(Spectrum spectrum, double deltaT, List<SolverChoice> solvers,
            ProgressListener progress) {
        return progress.onAllCores(solvers, SolverChoice::label, solver -> limit(spectrum, deltaT, solver));
    }

    /** As {@link #limits}, of one solver. */
    public static Limit limit(Spectrum spectrum, double deltaT, SolverChoice solver) {
        Amplification amplification = Amplification.of(solver);
        Map<List<Long>, Mode> fastest = new LinkedHashMap<>();       // of each direction
        spectrum.decaying().forEach(mode -> fastest.putIfAbsent(List.of(Math.round(mode.re() / mode.size()
                / SAME_DIRECTION), Math.round(mode.damping() / mode.size() / SAME_DIRECTION)), mode));
        Mode deciding = null;
        double longest = Double.POSITIVE_INFINITY;
        for (Mode mode : fastest.values()) {
            double limit = StabilityLimit.measure(h -> amplification.of(mode, h / mode.size())).value() / mode.size();
            deciding = limit < longest ? mode : deciding;
            longest = Math.min(limit, longest);
        }
        Mode most = spectrum.decaying().stream().max(Comparator.comparingDouble(mode ->
                amplification.of(mode, deltaT))).orElseThrow();
        Mode named = longest > 0 ? deciding : solver.adaptive() ? null : most;
        return new Limit(solver, longest, amplification.of(most, deltaT) - 1, Optional.ofNullable(named));
    }

    /** @return the spectrum of the scene's start, without modes too slow to be seen in the scene's duration */
    public static Spectrum spectrum(SceneDescription scene) {
        Spectrum all = Spectrum.of(SceneRun.build(scene, Setting.of(SolverChoice.RK4, scene.deltaT())).system());
        return new Spectrum(all.modes().stream().filter(mode -> mode.size() * scene.duration() > SLOWEST).toList());
    }

    /**
     * @param limits the limits of the solvers
     * @param deltaT the scene's step, for which growth is given
     * @return the table: a row for each solver
     */
    public static DataTable table(List<Limit> limits, double deltaT) {
        return DataTable.of("longest-stable-step", "The longest stable deltaT and the mode that sets it, from the"
                + " equations linearised at the scene's start. Where every step grows: by how much in the scene's step,"
                + " " + Digits.exact(deltaT) + " s", limits, column("solver", limit -> limit.solver().label()),
                column("longest stable deltaT (s)", Limit::text),
                column("|lambda| of the mode (1/s)", 4, limit -> limit.mode().map(Mode::size).orElse(Double.NaN)),
                column("moves most", limit -> limit.mode().map(Mode::farthest).orElse("")));
    }

    /**
     * @param scene    the title of the scene
     * @param spectrum the spectrum of its start
     * @param deltaT   the scene's step (s)
     * @param solvers  the solvers whose outlines are drawn
     * @return the step times each eigenvalue, with the outlines of the regions
     */
    public static Panel plane(String scene, Spectrum spectrum, double deltaT, List<SolverChoice> solvers) {
        double far = spectrum.modes().stream().mapToDouble(mode -> 1.1 * deltaT * mode.size()).reduce(3, Math::max);
        // an outline smaller than a cell of the map has no points
        Stream<Series> outlines = solvers.stream().map(solver -> StabilityMap.of(Amplification.of(solver), far)
                .outline(solver.look(), solver.label())).filter(outline -> outline.x().length > 0);
        Series modes = Series.of(Look.number(0), "modes of the scene", Mark.POINTS, spectrum.modes().stream()
                .flatMap(mode -> Stream.of(mode.im(), -mode.im()).map(im ->
                        new double[] {deltaT * mode.re(), deltaT * im})).toList());
        return Panel.map(scene + ": eigenvalues times deltaT = " + Digits.few(deltaT) + " s",
                StabilityMap.plane(far, Stream.concat(outlines, Stream.of(modes)).toList()));
    }
}
