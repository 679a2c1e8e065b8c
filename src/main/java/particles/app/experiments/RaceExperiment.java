package particles.app.experiments;

import deSolvers.text.Digits;
import java.util.List;
import java.util.stream.Stream;
import particles.app.experiments.Experiment.Run;
import particles.app.run.CameraFinder;
import particles.experiments.race.Race;
import particles.experiments.race.Race.Result;
import particles.experiments.race.RaceCharts;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.output.animation.GifAnimation;
import particles.output.animation.RaceFilm;
import particles.output.charts.ChartPage;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.scene.format.OutputDescription.Frames;
import particles.scene.format.SceneDescription;
import particles.view.Axis;
import particles.view.Camera;
import particles.view.Chart;
import particles.view.Panel;

/** A race: solvers with equal work side by side. */
final class RaceExperiment {
    /** Frames shown in a second. */
    private static final double PLAYBACK = 20;
    private static final int FEWEST_FRAMES = 40;
    private static final int MOST_FRAMES = 300;
    private static final int MOST_SOLVERS = 16;

    private RaceExperiment() {
    }

    static Run plan(DeclaredCommand asked) {
        SceneDescription scene = asked.scene();
        List<SolverChoice> solvers = asked.solvers();
        double duration = scene.duration();
        if (!(duration > 0)) {
            throw asked.wrong("set", "the duration is 0 s, and a race needs more; add duration=SECONDS");
        }
        if (solvers.size() > MOST_SOLVERS) {
            throw asked.wrong("solvers", solvers.size() + " solvers are too many; at most " + MOST_SOLVERS);
        }
        int frames = (int) Math.max(FEWEST_FRAMES, Math.min(MOST_FRAMES, Math.round(PLAYBACK * duration)));
        Camera camera = CameraFinder.find(scene);
        Frames size = scene.output().frames();
        // panels fill the page, unless the scene's frames are wider
        double aspect = Math.max(RaceFilm.aspect(solvers.size()), (double) size.width() / size.height());
        return (folder, progress) -> {
            try (RaceFilm film = new RaceFilm(solvers.size(), aspect, frames / duration, PLAYBACK)) {
                Result race = new Race(scene, solvers, frames).run((built, solver) -> List.of(film.watch(
                        solver.map(SolverChoice::look), new FrameSetup(camera, scene.drawing().look(),
                        built.scenery(), "", ""))), progress.part(0, 0.5));
                ProgressListener drawing = progress.part(0.5, 1);
                Chart strip = new Chart(Axis.TIME, Axis.log("|energy error|", "%"), RaceCharts.energy(race).series());
                film.write(folder, head(race), strip, part -> drawing.reached(part, "drawing the animation"));
                return page(asked, race, film.sheet(head(race), strip));
            }
        };
    }

    private static RaceFilm.Head head(Result race) {
        return new RaceFilm.Head(RaceCharts.title(race), "Beside each solver: its distance from the grey ghost, root"
                + " mean square. The ghost is " + Race.REFERENCE + ".", race.lanes().stream().map(lane ->
                new RaceFilm.Words(lane.label(), lane.look(), RaceCharts.mean(lane), step(lane.drift().setting())
                + ", " + lane.drift().outcome().evaluations() + " evaluations", lane.left())).toList());
    }

    /** Two digits, as there is little room; the table has the others. */
    private static String step(Setting setting) {
        return setting.tolerance().map(t -> "tolerance " + Digits.few(t, 2)).orElseGet(() ->
                "deltaT = " + Digits.few(setting.deltaT(), 2) + " s");
    }

    private static ResultPage page(DeclaredCommand asked, Result race, ChartPage sheet) {
        return asked.page(RaceCharts.title(race), List.of(Picture.made(GifAnimation.FILE,
                "The race. The grey ghost is the reference; a solver that fails leaves the race."),
                        Picture.drawn("race", "The end of the race, and the energy error over time.", sheet),
                        Picture.of("race-charts", """
                                Above: the distance from the reference, root mean square over the particles; it is \
                                left out if particles are born or die. At the curves: its root mean square over time. \
                                Below: the energy error; at the curves, the largest. A cross marks where a solver left \
                                the race.""",
                                Panel.of(RaceCharts.title(race), Stream.of(RaceCharts.distance(race),
                                RaceCharts.energy(race)).filter(chart -> chart.series().stream().anyMatch(series ->
                                series.x().length > 0)).toList()))),
                List.of(RaceCharts.table(race)));
    }
}
