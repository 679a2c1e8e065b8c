package particles.app.run;

import deSolvers.text.Digits;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import particles.NumericalErrorException;
import particles.SimulationException;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.FolderSize;
import particles.app.cli.OptionStyle;
import particles.app.student.StudentClasses;
import particles.experiments.energy.NumericalErrorLimit;
import particles.messages.BlowUpMessage;
import particles.messages.FrictionMessage;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.files.RunSummaryWriter;
import particles.scene.Overrides;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.OutputDescription.Video;
import particles.scene.format.SceneDescription;
import particles.threads.ParallelForces;

/** Runs one scene and writes a folder of results, which is complete even if the run ends early. */
final class RunJob {
    private final Path file;
    private final Overrides overrides;
    private final Path results;
    private final boolean frames;
    private final Optional<Video> wanted;
    private final ChartFormat charts;
    private final OptionStyle style;
    private final StopRequest stop;

    /**
     * @param file      the scene
     * @param overrides options that override it
     * @param results   the folder for results
     * @param frames    whether pictures are drawn
     * @param wanted    the film requested by an option, if any
     * @param charts    the format of the charts
     * @param style     the way in which options are typed, for messages
     * @param stop      tells the run to end early
     */
    RunJob(Path file, Overrides overrides, Path results, boolean frames, Optional<Video> wanted,
           ChartFormat charts, OptionStyle style, StopRequest stop) {
        this.file = file;
        this.overrides = overrides;
        this.results = results;
        this.frames = frames;
        this.wanted = wanted;
        this.charts = charts;
        this.style = style;
        this.stop = stop;
    }

    /**
     * Runs the scene.
     *
     * @param out the output for progress and the summary
     * @throws Failure if the run ended early; the results until then are complete
     */
    void run(PrintWriter out) {
        SceneDescription described = overrides.applyTo(SceneReader.read(file, new StudentClasses()));
        String hash = FileHash.of(file);
        Scene scene = SceneBuilder.build(described);
        if (frames) {
            SceneBuilder.checkPictures(described, style.option("frames"));
        }
        TimeEstimate.of(described, frames).ifPresent(line -> {
            out.println(line);
            out.flush();
        });
        Video video = frames ? wanted.orElse(described.output().video()) : Video.NONE;
        RunFiles files = new RunFiles(described.output(), frames, video, charts);
        try (OutputFolder folder = OutputFolder.open(results, files.names())) {
            stop.addLastResort(folder::close);
            Progress progress = new Progress(out, scene.simulation().getDuration(), System::nanoTime);
            RunObservers observers = new RunObservers(scene, folder);
            Optional<String> early;
            try (observers) {
                if (files.haveFrames()) {
                    observers.addFrames(CameraFinder.find(described), video);
                }
                observers.add(progress);
                observers.add(new StopObserver(stop));
                observers.add(new NumericalErrorLimit(observers.energy(), observers.books(), scene.energyEstimate()));
                early = simulateOrDiscard(scene, folder, observers);
            }
            Summary summary = new Summary(SceneName.of(file).whole(), hash, scene, observers.energy(),
                    observers.books(),
                    progress.seconds());
            RunSummaryWriter.write(folder, summary.record());
            observers.drawCharts(charts);
            summary.lines(early.isPresent()).forEach(out::println);
            out.println("files in " + results + ": " + String.join(", ", files.names()));
            FolderSize.notice(results, style).ifPresent(out::println);
            early.ifPresent(why -> {
                throw new Failure(ExitCode.STOPPED, why);
            });
        }
    }

    /** If a run fails, for example on a full disk, incomplete files are deleted. */
    private Optional<String> simulateOrDiscard(Scene scene, OutputFolder folder, RunObservers observers) {
        try {
            return simulate(scene, observers);
        } catch (RuntimeException | Error e) {
            folder.discard();
            throw e;
        }
    }

    /** @return the reason why the run ended early, if it did */
    private Optional<String> simulate(Scene scene, RunObservers observers) {
        ParallelForces.use(scene.system(),
                scene.description().settings().threads().orElseGet(Runtime.getRuntime()::availableProcessors));
        try {
            scene.simulation().run();
            return Optional.empty();
        } catch (SimulationException e) {
            if (!(e instanceof NumericalErrorException error) || error.isEarly()) {
                observers.showEnd((BlowUpMessage.isBlowUp(e) ? "blew up" : "stopped") + " at t = "
                        + Digits.few(e.getTime()) + " s");
            }
            return FrictionMessage.of(scene, style::option,
                    e).or(() -> Optional.of(new BlowUpMessage(scene, style::option).of(e)));
        } catch (StoppedException e) {
            return Optional.of(e.getMessage() + " at t = " + Digits.few(scene.system().getTime()) + " s of "
                    + Digits.few(scene.simulation().getDuration()) + " s");
        } finally {
            ParallelForces.use(scene.system(), 1);
        }
    }
}
