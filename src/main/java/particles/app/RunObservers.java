package particles.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.Camera;
import particles.ChartData;
import particles.Observer;
import particles.ParticleSystem;
import particles.VectorField;
import particles.experiments.Axis;
import particles.experiments.EnergyBooks;
import particles.experiments.EnergyHistory;
import particles.experiments.PhaseHistory;
import particles.experiments.VectorFields;
import particles.messages.Digits;
import particles.output.ChartWriter;
import particles.output.Film;
import particles.output.FrameObserver;
import particles.output.FrameRenderer;
import particles.output.FrameSink;
import particles.output.GifAnimation;
import particles.output.OutputFolder;
import particles.output.PngFrames;
import particles.output.Stage;
import particles.output.TrajectoryWriter;
import particles.scene.OutputDescription;
import particles.scene.OutputDescription.Video;
import particles.scene.Scene;

/** What looks on while a scene runs, and makes files of what it sees. */
final class RunObservers implements AutoCloseable {
    /** A trajectory of no more lines than this can be opened by anything. */
    private static final long MOST_LINES = 200_000;
    /** So many samples of the energies are taken at most; they cost about what half an evaluation does. */
    private static final long MOST_ENERGIES = 100_000;

    private static final int ANIMATION_WIDTH = 640;
    private static final int MOST_DECIMALS = 6;

    private final Scene scene;
    private final OutputFolder folder;
    private final TrajectoryWriter trajectory;
    private final EnergyHistory energy;
    private final EnergyBooks books;
    private final Optional<PhaseHistory> phase;
    private Optional<FrameObserver> frames = Optional.empty();

    /**
     * @param scene  a scene that is about to run
     * @param folder where files go
     */
    RunObservers(Scene scene, OutputFolder folder) {
        this.scene = scene;
        this.folder = folder;
        OutputDescription output = scene.output();
        double steps = Math.ceil(scene.simulation().getDuration() / scene.simulation().getDeltaT());
        int particles = scene.system().getParticles().count();
        long stride = output.trajectoryStride().map(Integer::longValue)
                .orElseGet(() -> TrajectoryWriter.strideFor(steps, particles, MOST_LINES));
        trajectory = new TrajectoryWriter(folder, stride);
        long energies = TrajectoryWriter.strideFor(steps, 1, MOST_ENERGIES);
        energy = new EnergyHistory(energies);
        books = new EnergyBooks(energies);
        phase = scene.phase().map(plot -> new PhaseHistory(scene.system().getParticles().id(plot.particle())));
        add(trajectory);
        add(energy);
        add(books);
        phase.ifPresent(this::add);
    }

    /** @param observer one more, told after those that are there */
    void add(Observer observer) {
        scene.simulation().addObserver(observer);
    }

    /**
     * Has frames drawn, an animation made of them if the scene wants one, and a film if one is wanted.
     *
     * @param camera from where
     * @param video  which film
     */
    void addFrames(Camera camera, Video video) {
        OutputDescription output = scene.output();
        Stage stage = new Stage(camera, scene.look(), scene.scenery(), scene.description().title(), caption());
        int decimals = (int) Math.max(0, Math.min(MOST_DECIMALS, Math.ceil(Math.log10(output.frameRate()))));
        FrameRenderer renderer = new FrameRenderer(stage, output.width(), output.height(), decimals);
        List<FrameSink> sinks = new ArrayList<>(List.of(new PngFrames(folder, output.width(), output.height())));
        if (output.animation()) {
            sinks.add(new GifAnimation(folder, renderer, ANIMATION_WIDTH, output.frameRate()));
        }
        if (video == Video.MP4) {
            sinks.add(new Film(folder, output.width(), output.height(), output.frameRate()));
        }
        FrameObserver observer = new FrameObserver(renderer, output.frameRate(), sinks);
        frames = Optional.of(observer);
        add(observer);
    }

    EnergyHistory energy() {
        return energy;
    }

    EnergyBooks books() {
        return books;
    }

    /** Completes the files that were written during the run, also where it ended early. */
    @Override
    public void close() {
        try {
            trajectory.close();
        } finally {
            frames.ifPresent(FrameObserver::close);
        }
    }

    /** Draws what was recorded. */
    void drawCharts() {
        String title = scene.description().title() + " (" + caption() + ")";
        if (scene.output().energy()) {
            List<ChartData> charts = new ArrayList<>(List.of(energy.chart(title)));
            charts.addAll(books.charts(energy.getScale()));
            ChartWriter.writeStacked(folder, RunFiles.ENERGY, charts);
        }
        phase.ifPresent(history -> drawPhase(history, Axis.values()[scene.phase().orElseThrow().axis()], title));
    }

    private void drawPhase(PhaseHistory history, Axis axis, String title) {
        ParticleSystem system = scene.system();
        ChartData path = history.chart(axis, title);
        ChartData.Series states = path.series().get(0);
        Optional<VectorField> field = VectorFields.around(system, axis, states.x(), states.y());
        ChartWriter.writePhase(folder, RunFiles.PHASE, path, field);
    }

    /** What tells this run from others of the scene. */
    private String caption() {
        return scene.description().solver() + ", deltaT = " + Digits.exact(scene.simulation().getDeltaT()) + " s";
    }
}
