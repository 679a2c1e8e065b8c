package particles.scene;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import particles.scene.format.SceneDescription;

/** Scenes for tests. */
public final class TestScenes {
    /** The folder of the project's scenes. */
    public static final Path FOLDER = Path.of("scenes");

    private TestScenes() {
    }

    /** @return the files of the project's scenes */
    public static List<Path> files() {
        return SceneFiles.list(FOLDER);
    }

    /** @return a scene of the project, by its name or number */
    public static SceneDescription named(String name) {
        return SceneReader.read(SceneFiles.find(FOLDER, name));
    }

    /** @return the scene with this text; messages name it {@code x.yaml} */
    public static SceneDescription read(String yaml) {
        return SceneReader.read("x.yaml", yaml.getBytes(StandardCharsets.UTF_8));
    }

    /** @return the scene with this text, ready to run */
    public static Scene build(String yaml) {
        return SceneBuilder.build(read(yaml));
    }

    /** @return the text of a scene whose steps of 0.5 s take several swings of a stiff spring to a shaken hand */
    public static String shaken(String solver, double period) {
        return """
                title: A hand shakes a block
                teaches: A step of many swings.
                solver: SOLVER
                deltaT: 0.5
                duration: 2
                particles:
                  - {id: hand, position: [0, 0, 0], fixed: true}
                  - {id: block, position: [0, -1, 0]}
                springs:
                  - {from: hand, to: block, stiffness: 1000, restLength: 1, damping: 1}
                rules:
                  - shake: {particle: hand, amplitude: [0, 0.1, 0], period: PERIOD}
                """.replace("SOLVER", solver).replace("PERIOD", "" + period);
    }
}
