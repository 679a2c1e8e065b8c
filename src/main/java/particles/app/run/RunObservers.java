package particles.app.run;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import particles.Observer;
import particles.energy.EnergyRecorder;
import particles.experiments.phase.Coordinate;
import particles.experiments.phase.PhaseHistory;
import particles.experiments.phase.VectorFields;
import particles.experiments.runs.SolverChoice;
import particles.lab.Replay;
import particles.output.animation.Film;
import particles.output.animation.GifAnimation;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartWriter;
import particles.output.files.OutputFolder;
import particles.output.files.TrajectoryWriter;
import particles.output.frames.FrameDrawer;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.FrameSink;
import particles.output.frames.LastSteps;
import particles.output.frames.MotionFile;
import particles.output.report.Picture;
import particles.output.usd.ObjFrames;
import particles.output.usd.UsdFile;
import particles.scene.Scene;
import particles.scene.format.OutputDescription;
import particles.scene.format.OutputDescription.Frames;
import particles.scene.format.SceneDescription;
import particles.spec.JsonText;
import particles.view.Camera;
import particles.view.Chart;
import particles.view.Panel;
import particles.view.Series;

/** The observers of a run that write its files. */
final class RunObservers implements AutoCloseable {
    /** The largest number of lines of a trajectory, which any program can open. */
    private static final long MOST_LINES = 200_000;
    /** The largest number of energy samples; each costs about half an evaluation. */
    private static final long MOST_ENERGIES = 100_000;

    private static final String ENERGY = "energy";
    private static final String PHASE = "phase";

    private final Scene scene;
    private final SceneDescription description;
    private final OutputDescription output;
    private final OutputFolder folder;
    private final TrajectoryWriter trajectory;
    private final EnergyRecorder energy;
    private final List<Observer> others = new ArrayList<>();
    private final List<MotionFile> motion = new ArrayList<>();
    private final FrameObserver frames;
    private final Optional<Replay> replay;
    private final Optional<PhaseHistory> phase;
    private Consumer<String> end = headline -> { };

    /** The files of a run that are only written if they are asked for. */
    record Extras(boolean replay, boolean usd, boolean obj) {
    }

    /**
     * @param output the scene's output settings
     * @param charts the format of charts
     * @param extras the files besides those that every run writes
     * @return the names of the files that a run writes, the most interesting first
     */
    static List<String> files(OutputDescription output, ChartFormat charts, Extras extras) {
        boolean phase = output.phase().isPresent();
        Map<String, Object> wanted = JsonText.map(OutputFolder.FRAMES, output.frames().drawn() || extras.obj,
                GifAnimation.FILE, output.frames().animation() > 0, Film.FILE, output.frames().film(),
                ENERGY + ChartWriter.PNG, output.energy(), PHASE + ChartWriter.PNG, phase,
                ENERGY + ChartWriter.SVG, charts.svg() && output.energy(),
                PHASE + ChartWriter.SVG, charts.svg() && phase,
                ChartWriter.PDF, charts.slide() && (output.energy() || phase), Replay.FILE, extras.replay,
                UsdFile.FILE, extras.usd,
                TrajectoryWriter.FILE, true, Summary.FILE, true);
        return wanted.keySet().stream().filter(name -> wanted.get(name).equals(true)).toList();
    }

    /**
     * @param scene  a scene that is about to run
     * @param folder the output folder
     * @param extras the files besides those that every run writes
     */
    RunObservers(Scene scene, OutputFolder folder, Extras extras) {
        this.scene = scene;
        this.folder = folder;
        description = scene.description();
        output = description.output();
        double steps = Math.ceil(scene.simulation().getDuration() / scene.simulation().getDeltaT());
        trajectory = new TrajectoryWriter(folder, count -> output.trajectoryStride().map(Integer::longValue)
                .orElseGet(() -> TrajectoryWriter.strideFor(steps, count, MOST_LINES)));
        energy = new EnergyRecorder(scene.simulation(), scene.energyEstimate(),
                TrajectoryWriter.strideFor(steps, 1, MOST_ENERGIES));
        phase = output.phase().map(plot -> new PhaseHistory(plot.particle(), plot.about(), steps));
        this.replay = extras.replay ? Optional.of(new Replay(scene, energy.getLedger())) : Optional.empty();
        this.replay.map(Replay::getRecorder).ifPresent(others::add);
        others.add(trajectory);
        phase.ifPresent(others::add);
        if (output.frames().drawn() || extras.usd) {
            Camera camera = CameraFinder.find(description);
            FrameSetup stage = new FrameSetup(camera, description.drawing().look(), scene.scenery(),
                    description.title(), caption());
            if (output.frames().drawn()) {
                addFrames(stage, output.frames());
            }
            if (extras.usd) {
                motion.add(new UsdFile(folder, stage, output.frames().width(), output.frames().height(),
                        output.frames().playbackRate()));
            }
        }
        if (extras.obj) {
            motion.add(new ObjFrames(folder, scene.scenery().surfaces()));
        }
        frames = new FrameObserver(description.drawing().look().style(), output.frames().rate(), motion);
        if (!motion.isEmpty()) {
            others.add(frames);
        }
    }

    /** Attaches all observers to the run that is about to begin, and then others. */
    void attach(Observer... last) {
        others.addAll(List.of(last));
        energy.attachTo(scene.simulation(), others);
    }

    /** Has frames drawn, and makes the animation and film, if wanted. */
    private void addFrames(FrameSetup stage, Frames format) {
        int decimals = (int) Math.max(0, Math.ceil(Math.log10(format.rate())));
        FrameRenderer renderer = new FrameRenderer(stage, format.width(), format.height(), decimals);
        List<FrameSink> sinks = new ArrayList<>(List.of(FrameSink.png(folder, format.width(), format.height())));
        if (format.animation() > 0) {
            sinks.add(new GifAnimation(folder, format.width(), format.height(), format.animation(),
                    format.playbackRate()));
        }
        if (format.film()) {
            sinks.add(new Film(folder, format.width(), format.height(), format.playbackRate()));
        }
        FrameDrawer drawer = new FrameDrawer(renderer, sinks);
        motion.add(drawer);
        LastSteps last = new LastSteps(stage.camera(), format.width(), format.height());
        others.add(last);
        end = headline -> drawer.replay(scene.system(), last, headline, format.rate());
    }

    /**
     * Shows the last steps in slow motion, if there are pictures.
     *
     * @param headline the text that says when the run ended early
     */
    void showEnd(String headline) {
        end.accept(headline);
    }

    EnergyRecorder getEnergy() {
        return energy;
    }

    /** Completes the files written during the run, even if it ended early. */
    @Override
    public void close() {
        try (frames) {
            trajectory.close();
        }
    }

    /**
     * Draws the charts of the recorded data.
     *
     * @param format the format of the charts
     */
    void drawCharts(ChartFormat format) {
        if (!output.energy() && phase.isEmpty()) {
            return;                                     // drawing classes are not even loaded
        }
        String title = description.title() + ": " + caption();
        List<Picture> pictures = new ArrayList<>();
        if (output.energy()) {
            List<Chart> charts = new ArrayList<>(List.of(energy.getHistory().chart()));
            charts.addAll(energy.getLedger().charts(energy.getScale(), energy.getHistory().hasGrown()));
            pictures.add(Picture.of(ENERGY, "", Panel.of(title, charts)));
        }
        phase.ifPresent(history -> {
            Coordinate axis = Coordinate.values()[output.phase().orElseThrow().axis()];
            SolverChoice solver = SolverChoice.of(description.solver());
            Chart path = history.chart(axis, solver.look(), solver.label());
            Series states = path.series().get(0);
            pictures.add(Picture.of(PHASE, "", Panel.phase(title, path,
                    VectorFields.around(scene.system(), axis, states.x(), states.y()))));
        });
        try (ChartWriter writer = new ChartWriter(folder, format)) {
            pictures.stream().flatMap(picture -> picture.laidOut(format).stream()).forEach(picture ->
                    writer.write(picture.file(), picture.page(format).orElseThrow()));
        }
    }

    /**
     * Writes the replay, if there is one.
     *
     * @param file    the scene file's name
     * @param text    its text
     * @param failure why the run ended early; empty if it did not
     * @return a line about states that were left out
     */
    Optional<String> writeReplay(String file, String text, String failure) {
        replay.ifPresent(recorded -> folder.write(Replay.FILE, recorded.page(file, text, failure)));
        return replay.flatMap(Replay::thinning).map(line -> Replay.FILE + ": " + line);
    }

    /** The caption: solver and settings of this run. */
    private String caption() {
        return description.solver() + ", deltaT = " + Digits.exact(scene.simulation().getDeltaT()) + " s";
    }
}
