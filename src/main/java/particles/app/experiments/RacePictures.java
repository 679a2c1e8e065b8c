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
import particles.output.charts.ChartWriter;
import particles.output.frames.FrameSetup;
import particles.output.race.RaceFilm;
import particles.output.raster.CameraFraming;
import particles.scene.Scene;
import particles.view.Camera;

/** Watches a race, and makes its film. The panels take their shape from where the reference goes. */
final class RacePictures implements Race.ObserverFactory, AutoCloseable {
    /**
     * The margin around the reference's box, as a part of its largest extent; a solver that leaves the box is still
     * visible for a while.
     */
    private static final double ROOM = 0.06;
    private static final double WIDEST = 16.0 / 9;
    private static final double NARROWEST = 0.9;

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
            begin(extent);
        }
        FrameSetup stage = new FrameSetup(camera.orElseThrow(), scene.description().drawing().look(),
                scene.scenery(), "", "");
        RaceFilm made = film.orElseThrow();
        return List.of(solver.isPresent() ? made.watch(solver.get().label(), stage) : made.watchReference(stage));
    }

    private void begin(Extent extent) {
        double room = ROOM * (extent.longest() > 0 ? extent.longest() : 1);     // where nothing moves, 1 m around it
        Vector3 around = new Vector3(room, room, extent.high().z() > extent.low().z() ? room : 0);
        Vector3 low = extent.low().minus(around);
        Vector3 high = extent.high().plus(around);
        double aspect = (high.x() - low.x() + high.z() - low.z()) / Math.max(room, high.y() - low.y());
        aspect = Math.max(NARROWEST, Math.min(WIDEST, aspect));
        camera = Optional.of(CameraFraming.around(low, high, aspect));
        film = Optional.of(new RaceFilm(panels, aspect, rate, playback));
    }

    /**
     * Writes the film and the sheet.
     *
     * @param writer   writes the sheet, and has the output folder
     * @param sheet    the name of the sheet
     * @param race     the result of the race
     * @param progress receives the progress
     */
    void write(ChartWriter writer, String sheet, Result race, DoubleConsumer progress) {
        List<RaceFilm.Words> words = race.lanes().stream().map(lane -> new RaceFilm.Words(
                lane.label(), step(lane), cost(lane, race.equalTime()), lane.left()))
                .toList();
        film.orElseThrow().write(writer, sheet, new RaceFilm.Head(race.scene() + ": " + RaceCharts.work(race),
                RaceCharts.finding(race), "Grey ghost: the reference, " + Race.REFERENCE + ".", words),
                RaceCharts.energy(race), progress);
    }

    /** Two digits, as there is little room; the table has the others. */
    private static String step(Lane lane) {
        return lane.match().setting().tolerance().map(t -> "tolerance " + Digits.few(t, 2)).orElseGet(() -> "deltaT = "
                + Digits.few(lane.match().setting().deltaT(), 2) + " s");
    }

    private static String cost(Lane lane, boolean equalTime) {
        return equalTime ? Digits.few(1000 * lane.match().seconds().orElse(Double.NaN)) + " ms"
                : lane.match().evaluations() + " evaluations";
    }

    @Override
    public void close() {
        film.ifPresent(RaceFilm::close);
    }
}
