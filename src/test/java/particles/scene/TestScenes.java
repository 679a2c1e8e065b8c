package particles.scene;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import particles.scene.format.SceneDescription;

/** Scenes for tests. */
public final class TestScenes {
    /** The folder of the project's scenes. */
    public static final Path FOLDER = Path.of("scenes");

    private TestScenes() {
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
}
