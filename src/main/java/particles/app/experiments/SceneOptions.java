package particles.app.experiments;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import particles.app.cli.ProgramCommand.Mistakes;
import particles.app.cli.ResultsCommand;
import particles.app.student.StudentClasses;
import particles.experiments.runs.SolverChoice;
import particles.scene.Overrides;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
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
        Overrides overrides = new Overrides(command.getStyle()::option).with("deltaT", deltaT)
                .with("duration", duration);
        mistakes.check(overrides::check);
        description = mistakes.value(() -> overrides.applyTo(read(scene == null ? standardScene : scene)));
        choices = mistakes.value(() -> command.solverChoices(solvers == null ? standardSolvers : solvers));
    }

    /** @return a scene: a file, or the name or number of one in scenes */
    static SceneDescription read(String scene) {
        return SceneReader.read(SceneFiles.find(SCENES, scene), new StudentClasses());
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
