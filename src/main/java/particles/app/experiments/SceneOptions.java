package particles.app.experiments;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.app.cli.ProgramCommand;
import particles.app.cli.ProgramCommand.Mistakes;
import particles.app.student.StudentClasses;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.spec.Setting;
import picocli.CommandLine.Option;

/** The options of a command that looks at a scene, which may name students' classes. */
final class SceneOptions {
    private static final Path SCENES = Path.of("scenes");

    @Option(names = "--scene", paramLabel = "NAME",
            description = "The scene: a file, or the name or number of one in scenes.")
    private String scene;

    @Option(names = "--set", paramLabel = "KEY=VALUE, ...",
            description = "Other values for keys of the scene, such as 'deltaT=0.01, duration=5'.")
    private String set = "";

    private Supplier<Path> file;
    private Supplier<List<Setting>> settings;
    private Supplier<SceneDescription> description;

    /** Reads the options; without one, this scene is the default, or none if it is empty. */
    void read(Mistakes mistakes, ProgramCommand command, String standard) {
        scene = scene == null || scene.isBlank() ? standard : scene;    // null if the option is not given
        settings = mistakes.value(() -> command.settings("set", set));
        if (scene.isEmpty() && !set.isEmpty()) {
            mistakes.check(() -> {
                throw command.wrong("set", "goes with " + command.getStyle().option("scene") + " only");
            });
        } else if (!scene.isEmpty()) {
            file = mistakes.value(() -> SceneFiles.find(SCENES, scene));
            description = mistakes.value(() -> scene(List.of()));
        }
    }

    /** @return whether there is a scene, asked for or by default */
    boolean hasScene() {
        return !scene.isEmpty();
    }

    /** @return the scene, with the values that were set in place of its own */
    SceneDescription scene() {
        return description.get();
    }

    /** @return the scene with more values in place of its own */
    SceneDescription scene(List<Setting> more) {
        return SceneReader.read(file.get(), new StudentClasses(), Stream.concat(settings.get().stream(), more.stream())
                .toList());
    }

    /** @return the scene's file, and those that it names, with the values that were set */
    String text() {
        return SceneReader.withFiles(file.get(), new StudentClasses(), settings.get());
    }

    /** @return the unit of a key of the scene; empty if it has none */
    String unit(Setting key) {
        return SceneReader.unit(file.get(), new StudentClasses(), key);
    }

    /** @return the scene, as typed */
    String getTypedScene() {
        return scene;
    }

    /** @return the values, as typed; may be empty */
    String getTypedSet() {
        return set;
    }
}
