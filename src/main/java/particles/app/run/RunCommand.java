package particles.app.run;

import deSolvers.text.Digits;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.SimulationException;
import particles.app.cli.ChartOptions;
import particles.app.cli.ExitCode;
import particles.app.cli.ExitCode.Failure;
import particles.app.cli.ResultsCommand;
import particles.app.student.StudentClasses;
import particles.engine.ParallelForces;
import particles.lab.PageParts;
import particles.output.files.OutputFolder;
import particles.output.usd.UsdFile;
import particles.scene.BlowUpMessage;
import particles.scene.RunLimits;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneFiles.SceneName;
import particles.scene.SceneReader;
import particles.scene.format.OutputDescription;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.Digest;
import particles.spec.Setting;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * {@code gradle run}: runs a scene and writes frames, an animation, plots and numbers. The folder of results is
 * complete even if the run ends early.
 */
@Command(name = "run",
        description = "Runs a scene: pictures, an animation, energy and phase-space plots, the trajectory.")
public final class RunCommand extends ResultsCommand {
    @Option(names = "--scene", paramLabel = "NAME",
            description = "The scene: a file, or the name or number of one in scenes (default: ${DEFAULT-VALUE}).")
    private String wanted = SceneFiles.DEFAULT;

    @Option(names = "--solver", paramLabel = "NAME", description = "A solver other than the scene's.")
    private String solver;

    @Option(names = "--deltaT", paramLabel = "SECONDS", description = "A time step other than the scene's.")
    private String deltaT;

    @Option(names = "--duration", paramLabel = "SECONDS", description = "A duration other than the scene's.")
    private String duration;

    @Option(names = "--set", paramLabel = "KEY=VALUE, ...", description = "Other values for keys of the scene, such as"
            + " 'springs[0].damping=20, effects.gravity.acceleration=[0, -1.62, 0]'.")
    private String set = "";

    @Option(names = "--threads", paramLabel = "NUMBER",
            description = "How many threads evaluate the forces of a large system (default: one for each processor).")
    private String threads;

    @Option(names = "--frames", arity = "0..1", fallbackValue = "true", defaultValue = "true",
            paramLabel = "true|false",
            description = "Whether to draw pictures (default: true).")
    private boolean frames;

    @Option(names = "--video", paramLabel = "none|mp4",
            description = "Whether to make film.mp4 from the pictures (default: as the scene says, or none).")
    private String video;

    @Option(names = "--size", paramLabel = "WIDTHxHEIGHT",
            description = "The size of frames, animation and film (pixels), such as 1920x1080.")
    private String size;

    @Option(names = "--replay", arity = "0..1",
            paramLabel = "true|false",
            description = "Whether to write replay.html, the run in the lab's page (default: false).")
    private boolean replay;

    @Option(names = "--usd", arity = "0..1", paramLabel = "true|false",
            description = "Whether to write the motion as motion.usda, for Blender, Maya or Houdini (default: false).")
    private boolean usd;

    @Option(names = "--obj", arity = "0..1", paramLabel = "true|false",
            description = "Whether to write each frame as a Wavefront OBJ file (default: false).")
    private boolean obj;

    @Mixin
    private final ChartOptions charts = new ChartOptions();

    private final Path scenes;
    private final StopRequest stop;
    private String name = "";
    private String text = "";
    private SceneDescription description;

    /**
     * @param scenes the folder of scenes
     * @param stop   tells the run when it has to end early
     */
    public RunCommand(Path scenes, StopRequest stop) {
        this.scenes = scenes;
        this.stop = stop;
    }

    @Override
    protected String folderName() {
        return name.isBlank() || name.startsWith(".") ? "scene" + name : name;
    }

    @Override
    protected void read(Mistakes mistakes) {
        Supplier<List<Setting>> typed = settings(mistakes, List.of(SceneFormat.SOLVER, SceneFormat.DELTA_T,
                SceneFormat.DURATION, SceneFormat.THREADS), solver, deltaT, duration, threads);
        mistakes.check(() -> readScene(typed));
        super.read(mistakes);
        mistakes.check(this::checkPictures);
        mistakes.check(() -> {
            if (replay && !PageParts.areHere()) {
                throw wrong("replay", "the page's libraries are not in this program; type: gradle run -Preplay=true");
            }
        });
    }

    private void readScene(Supplier<List<Setting>> typed) {
        Path file = SceneFiles.find(scenes, wanted);
        byte[] bytes = SceneReader.bytes(file);
        name = SceneName.of(file).whole();
        text = new String(bytes, StandardCharsets.UTF_8);
        SceneDescription scene = SceneReader.read(file, new StudentClasses(), Stream.concat(
                settings("set", set).stream(), typed.get().stream()).toList());
        OutputDescription output = scene.output();
        boolean film = video != null ? video.equals(OutputDescription.MP4) : output.frames().film();
        description = scene.withOutput(frames ? sized(output.with(true, film)) : output.with(false, false));
        RunLimits.checkPictures(description, getStyle().option("frames"));
    }

    private OutputDescription sized(OutputDescription output) {
        if (size == null) {
            return output;
        }
        if (!size.matches("\\d{2,4}x\\d{2,4}")) {
            throw wrong("size", "'" + size + "' is not a size such as 1920x1080");
        }
        String[] sides = size.split("x");
        int width = Integer.parseInt(sides[0]);
        int height = Integer.parseInt(sides[1]);
        IntStream.of(width, height).sorted().forEach(side ->
                requireWithin("size", side, OutputDescription.LEAST_SIDE, OutputDescription.MOST_SIDE));
        return output.sized(width, height);
    }

    private void checkPictures() {
        if (video != null && !OutputDescription.FILMS.contains(video)) {
            throw wrong("video", "'" + video + "' is not a kind of film; allowed: "
                    + String.join(", ", OutputDescription.FILMS));
        }
        if (!frames && (OutputDescription.MP4.equals(video) || size != null)) {
            throw new InvalidInputException(getStyle().option(size != null ? "size" : "video")
                    + " needs pictures; remove " + getStyle().option("frames") + "=false");
        }
    }

    @Override
    public void run(PrintWriter out) {
        description.remarks().forEach(out::println);
        Scene scene = SceneBuilder.build(description);
        RunObservers.Extras extras = new RunObservers.Extras(replay, usd, obj);
        List<String> files = RunObservers.files(description.output(), charts.format(), extras);
        try (OutputFolder folder = OutputFolder.open(getFolder(), files.toArray(String[]::new))) {
            Progress progress = new Progress(out, description, System::nanoTime);
            RunObservers observers = new RunObservers(scene, folder, extras);
            Optional<String> early;
            try (observers; progress) {
                observers.attach(progress, stop);
                early = simulate(scene, folder, observers);
            }
            Summary summary = new Summary(name, Digest.of(text), set, scene, observers.getEnergy(),
                    progress.seconds());
            folder.write(Summary.FILE, summary.json());
            observers.drawCharts(charts.format());
            observers.writeReplay(name, text, early.orElse("")).ifPresent(out::println);
            summary.lines(early.isPresent()).forEach(out::println);
            out.println("files in " + getFolder() + ": " + String.join(", ", files));
            if (usd) {
                out.println(UsdFile.FILE + ": "
                        + Digits.few(getFolder().resolve(UsdFile.FILE).toFile().length() / 1e6) + " MB");
            }
            if (description.output().phase().isEmpty()) {
                out.println("no phase.png: under 'output', the scene names no particle for it");
            }
            Summary.sizeNotice(getFolder(), getStyle().option("frames")).ifPresent(out::println);
            early.ifPresent(why -> {
                throw new Failure(ExitCode.STOPPED, why);
            });
        }
    }

    /** @return the reason why the run ended early, if it did */
    private Optional<String> simulate(Scene scene, OutputFolder folder, RunObservers observers) {
        stop.letEnd(folder);
        ParallelForces.use(scene.system().getForceSum(),
                description.values().find(SceneFormat.THREADS).orElseGet(Runtime.getRuntime()::availableProcessors));
        try {
            scene.simulation().run();
            return Optional.empty();
        } catch (SimulationException e) {
            BlowUpMessage message = new BlowUpMessage(scene, e, getStyle()::option);
            if (e.getEnd() != SimulationException.End.WRONG_MOTION) {
                observers.showEnd((message.isBlowUp() ? "blew up" : "stopped") + " at t = "
                        + Digits.few(e.getTime()) + " s");
            }
            return Optional.of(message.lines());
        } catch (RuntimeException | Error e) {
            if (e instanceof CancellationException && stop.isWanted()) {    // not by a class of the user
                return Optional.of(e.getMessage() + " at t = " + Digits.few(scene.system().getTime()) + " s of "
                        + Digits.few(description.duration()) + " s");
            }
            folder.discard();                           // such as on a full disk: no incomplete file stays
            throw e;
        }
    }
}
