package particles.app.experiments;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import particles.app.cli.ProgramCommand.Mistakes;
import particles.app.cli.ResultsCommand;
import particles.app.student.StudentClasses;
import particles.experiments.runs.SolverChoice;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.Setting;
import picocli.CommandLine.Option;

/** The options of experiments that run a scene with several solvers. */
final class SceneOptions {
    static final Path SCENES = Path.of("scenes");

    @Option(names = "--scene", paramLabel = "NAME",
            description = "The scene: a file, or the name or number of one in scenes.")
    private String scene;

    @Option(names = "--solvers", paramLabel = "NAMES", description = "Solvers, separated by commas, or all.")
    private String solvers;

    @Option(names = "--deltaT", paramLabel = "SECONDS", description = "A time step other than the scene's.")
    private String deltaT;

    @Option(names = "--duration", paramLabel = "SECONDS", description = "A duration other than the scene's.")
    private String duration;

    private Supplier<SceneDescription> description;
    private Supplier<List<SolverChoice>> choices;

    /** Reads the options; these scene and solvers are the default. */
    void read(Mistakes mistakes, ResultsCommand command, String standardScene, String standardSolvers) {
        Supplier<List<Setting>> settings = command.settings(mistakes, List.of(SceneFormat.DELTA_T,
                SceneFormat.DURATION), deltaT, duration);
        scene = scene == null ? standardScene : scene;
        if (!scene.isEmpty()) {
            Supplier<Path> file = mistakes.value(() -> SceneFiles.find(SCENES, scene));
            description = mistakes.value(() -> read(file.get(), settings.get()));
        }
        choices = mistakes.value(() -> command.solverChoices(solvers == null ? standardSolvers : solvers));
    }

    /** @return a scene that may name students' classes, with these values in place of its own */
    static SceneDescription read(Path scene, List<Setting> settings) {
        return SceneReader.read(scene, new StudentClasses(), settings);
    }

    /** @return whether there is a scene, asked for or by default */
    boolean hasScene() {
        return description != null;
    }

    /** @throws particles.spec.messages.InvalidInputException if there is an option that needs a scene */
    void refuseWithoutScene(ResultsCommand command) {
        if (solvers != null || deltaT != null) {            // null if the option was not given
            throw command.wrong(solvers != null ? "solvers" : "deltaT", "goes with "
                    + command.getStyle().option("scene") + " only");
        }
    }

    /** @return the scene, with the options in place of its own values */
    SceneDescription scene() {
        return description.get();
    }

    /** @return the solvers */
    List<SolverChoice> solvers() {
        return choices.get();
    }
}
