package particles.app.run;

import java.nio.file.Path;
import particles.app.student.StudentClasses;
import particles.scene.SceneFiles;
import particles.scene.SceneName;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.documents.Reference;

/** The text of {@code scenes/README.md}: the gallery of scenes, and the reference of all keys of a scene file. */
public final class GalleryPage {
    /** The page's name, in the folder of scenes. */
    public static final String FILE = "README.md";
    /** The folder of its pictures, in the folder of scenes. */
    public static final String PICTURES = "pictures";

    private static final String BEGINNING = """
            # Scenes

            A scene is a text file that names particles, forces, rules and a solver. `gradle run -Pscene=9` runs scene
            9; `-Pscene=my-scene.yaml` runs a file of your own. To write one, copy the scene nearest to what you want
            and change it: each file explains itself in comments. Editors that know JSON Schema complete and check
            keys: the first line of a scene names the schema, `scene.schema.json`.

            `gradle gallery` writes this page, with one picture of each scene. Lines are the paths of
            particles.

            | picture | scene |
            | --- | --- |
            """;
    /** A picture twice as fine as it is shown, for sharp screens, and the words beside it. */
    private static final String ROW = """
            | <img src="%3$s/%1$s.png" alt="%6$s" width="320"> \
            | [%1$s](%1$s.yaml): **%2$s**<br>%4$s<br>Solver: %5$s |
            """;
    private static final String KEYS = """

            ## Keys of a scene file

            Lengths are in metres, masses in kilograms, times in seconds; y points up. Keys whose default is *required*
            have to be given, and keys with an empty default may be left out unless their meaning says otherwise. An
            unknown key is an error, reported with its line.

            """;

    private GalleryPage() {
    }

    /**
     * @param folder the folder of the scenes
     * @return the page, in Markdown
     */
    public static String of(Path folder) {
        StringBuilder page = new StringBuilder(BEGINNING);
        for (Path file : SceneFiles.list(folder)) {
            page.append(row(SceneName.of(file), SceneReader.read(file, new StudentClasses())));
        }
        return page + KEYS + Reference.of(SceneFormat.SCENE, "###");
    }

    private static String row(SceneName name, SceneDescription scene) {
        String words = String.join(" ", scene.values().get(SceneFormat.TEACHES).strip().split("\\s+"));
        String teaches = words.replace("|", "\\|");
        return ROW.formatted(name.whole(), scene.title(), PICTURES, teaches, scene.solver(),
                scene.title().replace("\"", "&quot;"));
    }
}
