package particles.app.experiments;

import deSolvers.text.Digits;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import particles.Observer;
import particles.experiments.race.Race;
import particles.experiments.race.Race.Lane;
import particles.experiments.race.Race.Result;
import particles.experiments.race.RaceCharts;
import particles.experiments.runs.Extent;
import particles.experiments.runs.SolverChoice;
import particles.law.Vector3;
import particles.output.charts.ChartPage;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.race.RaceFilm;
import particles.scene.Scene;
import particles.scene.format.OutputDescription.Frames;
import particles.scene.format.SceneDescription;
import particles.view.Camera;
import particles.view.ChartData;

/** Watches a race, and makes its film. The panels have the shape of the scene's own frames, or fill the page. */
final class RacePictures implements Race.ObserverFactory, AutoCloseable {
    /**
     * The margin around the reference's box, as a part of its largest extent; a solver that leaves the box is still
     * visible for a while.
     */
    private static final double ROOM = 0.06;

    private final int panels;
    private final double rate;
    private final double playback;
    private Optional<RaceFilm> film = Optional.empty();
    private Optional<Camera> camera = Optional.empty();

    /**
     * @param panels   the number of solvers
     * @param rate     the number of frames per second of simulated time (1/s)
     * @param playback the number of frames shown per second (1/s)
     */
    RacePictures(int panels, double rate, double playback) {
        this.panels = panels;
        this.rate = rate;
        this.playback = playback;
    }

    @Override
    public List<Observer> of(Scene scene, Optional<SolverChoice> solver, Extent extent) {
        if (solver.isEmpty()) {
            begin(scene.description(), extent);
        }
        FrameSetup stage = new FrameSetup(camera.orElseThrow(), scene.description().drawing().look(),
                scene.scenery(), "", "");
        RaceFilm made = film.orElseThrow();
        return List.of(solver.isPresent() ? made.watch(solver.get().label(), stage) : made.watchReference(stage));
    }

    /** A scene's own camera shows what it does in pictures of the scene; otherwise one is placed here. */
    private void begin(SceneDescription scene, Extent extent) {
        double room = ROOM * (extent.longest() > 0 ? extent.longest() : 1);     // where nothing moves, 1 m around it
        Vector3 around = new Vector3(room, room, extent.high().z() > extent.low().z() ? room : 0);
        Vector3 low = extent.low().minus(around);
        Vector3 high = extent.high().plus(around);
        Optional<Camera> own = scene.drawing().camera();
        Frames frames = scene.output().frames();
        double aspect = own.isPresent() ? (double) frames.width() / frames.height() : RaceFilm.aspect(panels);
        camera = Optional.of(own.orElseGet(() -> Camera.around(low, high, aspect)));
        film = Optional.of(new RaceFilm(panels, aspect, rate, playback));
    }

    /**
     * Writes the film.
     *
     * @param folder   the output folder
     * @param race     the result of the race
     * @param progress receives the progress
     * @return the page with its end
     */
    ChartPage write(OutputFolder folder, Result race, DoubleConsumer progress) {
        List<RaceFilm.Words> words = race.lanes().stream().map(lane -> new RaceFilm.Words(
                lane.label(), step(lane) + ", " + cost(lane, race.equalTime()), lane.left())).toList();
        RaceFilm.Head head = new RaceFilm.Head(race.scene() + ": " + RaceCharts.work(race),
                RaceCharts.finding(race), "Grey ghost: the reference, " + Race.REFERENCE + ".", words);
        ChartData strip = RaceCharts.energy(race);
        film.orElseThrow().write(folder, head, strip, progress);
        return film.get().sheet(head, strip);
    }

    /** Two digits, as there is little room; the table has the others. */
    private static String step(Lane lane) {
        return lane.match().setting().tolerance().map(t -> "tolerance " + Digits.few(t, 2)).orElseGet(() -> "deltaT = "
                + Digits.few(lane.match().setting().deltaT(), 2) + " s");
    }

    private static String cost(Lane lane, boolean equalTime) {
        return equalTime ? Digits.few(1000 * lane.match().seconds()) + " ms"
                : lane.match().evaluations() + " evaluations";
    }

    @Override
    public void close() {
        film.ifPresent(RaceFilm::close);
    }
}
