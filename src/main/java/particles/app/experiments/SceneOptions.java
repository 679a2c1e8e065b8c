package particles.app.experiments;

import java.nio.file.Path;
import java.util.List;
import java.util.NoSuchElementException;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.OptionStyle;
import particles.app.student.StudentClasses;
import particles.experiments.runs.SolverChoice;
import particles.scene.Overrides;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import picocli.CommandLine.Option;

/** The options of experiments that run a scene with several solvers. */
final class SceneOptions {
    private static final Path SCENES = Path.of("scenes");

    @Option(names = "--scene", paramLabel = "NAME",
            description = "The scene: a file, or the name or number of one in scenes.")
    private String scene;

    @Option(names = "--solvers", paramLabel = "NAMES", description = "Solvers, separated by commas, or all.")
    private String solvers;

    @Option(names = "--deltaT", paramLabel = "SECONDS", description = "A time step other than the scene's.")
    private String deltaT;

    @Option(names = "--duration", paramLabel = "SECONDS", description = "A duration other than the scene's.")
    private String duration;

    /** @return the scene in the options, or this one by default, with overrides applied */
    SceneDescription scene(String standard, OptionStyle style) {
        Path file = SceneFiles.find(SCENES, scene == null ? standard : scene);
        return overrides(style).applyTo(SceneReader.read(file, new StudentClasses()));
    }

    /** Checks the options that override a value of the scene. */
    void check(OptionStyle style) {
        overrides(style).check();
    }

    private Overrides overrides(OptionStyle style) {
        Overrides overrides = new Overrides();
        if (deltaT != null) {                           // picocli leaves an option null that was not given
            overrides.with("deltaT", deltaT, style.option("deltaT"));
        }
        if (duration != null) {
            overrides.with("duration", duration, style.option("duration"));
        }
        return overrides;
    }

    /** @return whether the options have another duration than the scene's */
    boolean haveDuration() {
        return duration != null;
    }

    /** @return the solvers in the options, or these by default */
    List<SolverChoice> solvers(String standard, OptionStyle style) {
        try {
            return SolverChoice.list(solvers == null ? standard : solvers);
        } catch (NoSuchElementException | IllegalArgumentException e) {
            throw new Failure(ExitCode.BAD_INPUT, "option " + style.option("solvers") + ": " + e.getMessage());
        }
    }
}
