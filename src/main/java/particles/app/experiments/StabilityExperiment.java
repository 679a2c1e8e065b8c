package particles.app.experiments;

import static particles.view.DataTable.column;

import deSolvers.catalog.SolverInfo.Group;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import particles.app.experiments.Experiment.Run;
import particles.experiments.stability.SceneStability;
import particles.experiments.stability.SolverStability;
import particles.experiments.stability.Spectrum;
import particles.experiments.stability.Spectrum.Mode;
import particles.output.report.Picture;
import particles.scene.format.SceneDescription;
import particles.view.DataTable;

/** The longest stable step, on every solver's real code or in one scene. */
final class StabilityExperiment {
    private static final int MOST_MODES = 12;

    private StabilityExperiment() {
    }

    static Run plan(DeclaredCommand asked) {
        if (!asked.hasScene()) {
            return limits(asked);
        }
        Spectrum spectrum = SceneStability.spectrum(asked.scene());
        if (spectrum.decaying().isEmpty()) {
            throw asked.wrong("scene", "this scene has no vibration or damping at its start that limits a step; choose"
                    + " a scene with springs, drag or rods between free particles");
        }
        return inScene(asked, spectrum);
    }

    private static Run limits(DeclaredCommand asked) {
        return (folder, progress) -> {
            List<SolverStability> measured = progress.part(0, 0.5).each(asked.solvers(), solver -> "limits of "
                    + solver.label(), SolverStability::of);
            Map<Optional<Group>, List<SolverStability>> groups = new LinkedHashMap<>();
            measured.forEach(one -> groups.computeIfAbsent(one.look().solver().map(info -> info.family().group()),
                    group -> new ArrayList<>()).add(one));
            return asked.page("Stability limits, measured", progress.part(0.5, 1).each(List.copyOf(groups.keySet()),
                    StabilityExperiment::name, group -> regions(name(group), groups.get(group))),
                    List.of(SolverStability.table(measured)));
        };
    }

    private static String name(Optional<Group> group) {
        return group.map(known -> known.name().toLowerCase(Locale.ROOT)).orElse("own");
    }

    /** Solvers of one group on one scale. */
    private static Picture regions(String group, List<SolverStability> solvers) {
        double far = solvers.stream().mapToDouble(SolverStability::reach).max().orElseThrow();
        return Picture.panels("region-" + group, """
                Stable in the shaded region, which may go on beyond the frame. Above it, the largest stable deltaT \
                omega of a critically damped spring, on the negative real axis, and of an undamped one, on the \
                imaginary axis.""",
                "Stability regions, measured: " + group, solvers.stream().map(one -> one.region(far)).toList());
    }

    /** The longest stable step of each solver in a scene with at least one mode that does not grow by itself. */
    private static Run inScene(DeclaredCommand asked, Spectrum spectrum) {
        SceneDescription scene = asked.scene();
        return (folder, progress) -> asked.page(scene.title() + ": longest stable step, fastest mode |lambda| = "
                + Digits.few(spectrum.decaying().get(0).size()) + " /s",
                List.of(Picture.of("eigenvalues", """
                        Each point is deltaT times an eigenvalue of the equations, linearised at the start. A step is \
                        stable if all points on the imaginary axis, or left of it, lie inside the outline of an \
                        explicit or symplectic solver, or outside that of an implicit one; implicit-midpoint's is the \
                        imaginary axis itself.""",
                        SceneStability.plane(scene.title(), spectrum, scene.deltaT(), asked.solvers()))
                        .first(List.of("euler", "midpoint", "rk4", "symplectic-euler", "verlet"))),
                List.of(SceneStability.table(SceneStability.limits(spectrum, scene.deltaT(), asked.solvers(), progress),
                        scene.deltaT()), modes(spectrum)));
    }

    private static DataTable modes(Spectrum spectrum) {
        return DataTable.of("modes", "The fastest modes of the scene's start",
                spectrum.modes().subList(0, Math.min(MOST_MODES, spectrum.modes().size())),
                column("Re lambda (1/s)", 6, Mode::re), column("Im lambda (1/s)", 6, Mode::im),
                column("period (s)", mode -> mode.im() == 0 ? Double.NaN : 2 * Math.PI / mode.im()),
                column("moves most", Mode::farthest));
    }
}
