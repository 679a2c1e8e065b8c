package particles.app.experiments;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.app.experiments.Experiment.Run;
import particles.experiments.lecture.LectureFigures;
import particles.experiments.lecture.LectureFigures.Figure;
import particles.experiments.lecture.LectureFigures.Result;
import particles.experiments.phase.Coordinate;
import particles.experiments.phase.PhasePortraits;
import particles.experiments.phase.PhasePortraits.Portraits;
import particles.law.Particles;
import particles.output.report.Picture;
import particles.scene.SceneBuilder;
import particles.scene.format.OutputDescription.Phase;
import particles.scene.format.SceneDescription;
import particles.view.Panel;
import particles.view.Series;

/** Plans of pictures of paths in state space. */
final class StateSpaceExperiments {
    private StateSpaceExperiments() {
    }

    static Run lectureFigures(DeclaredCommand asked) {
        return (folder, progress) -> {
            List<Result> results = progress.each(LectureFigures.ON_SLIDES, Figure::solver, LectureFigures::run);
            List<Panel> panels = new ArrayList<>(List.of(Panel.phase("The vector field (v, \u2212x)",
                    LectureFigures.exactChart(), Optional.of(LectureFigures.field(1.5)))
                    .answered("each solution is a circle").named("vector-field")));
            for (Result result : results) {
                Figure figure = result.figure();
                String step = Digits.exact(figure.deltaT());
                panels.add(Panel.phase(figure.solver() + ", deltaT = " + step + " s, " + figure.steps() + " steps",
                        LectureFigures.chart(result), Optional.of(LectureFigures.field(LectureFigures.reach(result))))
                        .answered(Digits.format("amplitude \u00d7 %.4g, phase error %+.3g rad", result.amplitude(),
                        result.phaseError())).named(figure.solver() + "-" + step + "s-" + figure.steps() + "-steps"));
            }
            String title = "The slides' figures: x'' = \u2212x in state space";
            return asked.page(title, List.of(Picture.panels("all-figures",
                    "All figures beside each other; each has its own scale.", title, panels)),
                    List.of(LectureFigures.table(results)));
        };
    }

    /** The particle and the axis are those of the scene's own phase plot. */
    static Run phasePlots(DeclaredCommand asked) {
        SceneDescription scene = asked.scene();
        Optional<Phase> plot = scene.output().phase();
        Particles all = SceneBuilder.build(scene).system().getParticles();
        // without a plot, the last free one at the start; particles that are born later have no complete path
        String particle = plot.map(Phase::particle).orElseGet(() -> all.id(all.free().max().orElseThrow(() -> asked
                .wrong("scene", "at its start this scene has no free particle, so there is no path to draw"))));
        return (folder, progress) -> {
            Portraits portraits = PhasePortraits.compare(scene, asked.solvers(), particle,
                    plot.map(phase -> Coordinate.values()[phase.axis()]), plot.flatMap(Phase::about), progress);
            String step = ", deltaT = " + Digits.exact(scene.deltaT()) + " s";
            String title = scene.title() + ": phase portraits" + step;
            List<Series> scale = portraits.portraits().stream().flatMap(one -> one.chart().series().stream()).toList();
            List<Panel> panels = portraits.portraits().stream().map(one -> Panel.phase(one.solver() + step,
                    one.chart().scaledTo(scale), Optional.empty()).answered(one.answer()).named(one.solver())).toList();
            return asked.page(title, List.of(Picture.panels("phase-plots", """
                    The pale band is the reference, dormand-prince with a tolerance of 1e-10. A cross is the end of a \
                    run that stopped, or the place where a path leaves the picture.""", title, panels)),
                    List.of(portraits.table()));
        };
    }
}
