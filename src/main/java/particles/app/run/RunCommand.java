package particles.app.run;

import java.io.PrintWriter;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import particles.app.cli.ChartOptions;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.OptionStyle;
import particles.app.cli.ProgramCommand;
import particles.scene.Overrides;
import particles.scene.SceneFiles;
import particles.scene.format.OutputDescription.Video;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle run}: runs a scene and writes frames, an animation, plots and numbers. */
@Command(name = "run",
        description = "Runs a scene: pictures, an animation, energy and phase-space plots, the trajectory.")
public final class RunCommand extends ProgramCommand {
    private static final Path RESULTS = Path.of("build", "out");

    @Option(names = "--scene", paramLabel = "NAME", defaultValue = SceneFiles.DEFAULT,
            description = "The scene: a file, or the name or number of one in scenes (default: ${DEFAULT-VALUE}).")
    private String scene;

    @Option(names = "--solver", paramLabel = "NAME", description = "A solver other than the scene's.")
    private String solver;

    @Option(names = "--deltaT", paramLabel = "SECONDS", description = "A time step other than the scene's.")
    private String deltaT;

    @Option(names = "--duration", paramLabel = "SECONDS", description = "A duration other than the scene's.")
    private String duration;

    @Option(names = "--threads", paramLabel = "NUMBER",
            description = "How many threads evaluate the forces of a large system (default: one for each processor).")
    private String threads;

    @Option(names = "--out", paramLabel = "FOLDER", description = "Where the results go (default: build/out/NAME).")
    private String out;

    @Option(names = "--frames", arity = "0..1", fallbackValue = "true", defaultValue = "true",
            paramLabel = "true|false",
            description = "Whether to draw pictures (default: true).")
    private boolean frames;

    @Option(names = "--video", paramLabel = "none|mp4", converter = VideoOption.class,
            description = "Whether to make film.mp4 from the pictures (default: as the scene says, or none).")
    private Video video;

    @Mixin
    private final ChartOptions charts = new ChartOptions();

    private final Path scenes;
    private final OptionStyle style;
    private final StopRequest stop;

    /**
     * @param scenes the folder of scenes
     * @param style  the way in which options are typed, for messages
     * @param stop   tells the run when it has to end early
     */
    public RunCommand(Path scenes, OptionStyle style, StopRequest stop) {
        this.scenes = scenes;
        this.style = style;
        this.stop = stop;
    }

    @Override
    protected List<Runnable> checks() {
        return List.of(this::file, () -> overrides().check(), this::checkVideo, this::folder);
    }

    @Override
    public void run(PrintWriter lines) {
        new RunJob(file(), overrides(), folder(), frames, Optional.ofNullable(video), charts.format(), style,
                stop).run(lines);
    }

    private Path file() {
        return SceneFiles.find(scenes, scene);
    }

    private Overrides overrides() {
        Overrides overrides = new Overrides();
        override(overrides, "solver", solver);
        override(overrides, "deltaT", deltaT);
        override(overrides, "duration", duration);
        override(overrides, "threads", threads);
        return overrides;
    }

    private void checkVideo() {
        if (!frames && video == Video.MP4) {
            throw new Failure(ExitCode.BAD_INPUT, style.option("video") + "=mp4 needs pictures; remove "
                    + style.option("frames") + "=false");
        }
    }

    private void override(Overrides overrides, String name, String value) {
        if (value != null) {                            // picocli leaves an option null that was not given
            overrides.with(name, value, style.option(name));
        }
    }

    private Path folder() {
        if (out == null) {
            String name = SceneName.of(file()).whole();
            return RESULTS.resolve(name.isBlank() || name.startsWith(".") ? "scene" + name : name);
        }
        try {
            if (!out.isBlank()) {
                return Path.of(out);
            }
        } catch (InvalidPathException e) {
            throw new Failure(ExitCode.BAD_INPUT, style.option("out") + ": '" + out + "' is not a folder name: "
                    + e.getReason());
        }
        throw new Failure(ExitCode.BAD_INPUT, style.option("out") + " needs a folder name");
    }
}
