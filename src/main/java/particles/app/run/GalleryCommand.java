package particles.app.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import particles.app.cli.ProgramCommand;
import particles.app.student.StudentClasses;
import particles.output.files.OutputFile;
import particles.output.files.PngEncoder;
import particles.output.frames.FrameDrawer;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.FrameSink;
import particles.output.frames.Pipeline;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneFiles.SceneName;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.Reference;
import particles.view.Camera;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import picocli.CommandLine.Command;

/** {@code gradle gallery}: one small picture of each scene, and the page that shows them. */
@Command(name = "gallery", description = "Draws a small picture of each scene and writes scenes/README.md.")
public final class GalleryCommand extends ProgramCommand {
    /** The width of a picture (pixels). */
    public static final int WIDTH = 640;
    /** The height of a picture (pixels). */
    public static final int HEIGHT = 360;
    /** The time of each picture, as a fraction of the run, when most scenes are in full motion. */
    private static final double MOMENT = 0.4;
    /** The largest number of trails; more would hide the motion. */
    private static final int MOST_TRAILS = 6;

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

    private final Path folder;

    /** @param folder the folder of the scenes and of the page */
    public GalleryCommand(Path folder) {
        this.folder = folder;
    }

    @Override
    public void run(PrintWriter out) throws IOException {
        // read all scenes before drawing any
        String page = page(folder);
        Path pictures = Files.createDirectories(folder.resolve(PICTURES));
        try (Pipeline<Path> scenes = new Pipeline<>(Runtime.getRuntime().availableProcessors(), () -> pictures)) {
            for (Path file : SceneFiles.list(folder)) {
                scenes.add(into -> {
                    String name = SceneName.of(file).whole();
                    draw(file, into.resolve(name + ".png"));
                    return () -> out.println(name);
                });
            }
        }
        OutputFile.write(folder.resolve(FILE), page.getBytes(StandardCharsets.UTF_8));
        out.println("the gallery: " + folder.resolve(FILE));
    }

    private static void draw(Path file, Path picture) {
        SceneDescription described = SceneReader.read(file, new StudentClasses());
        Camera camera = CameraFinder.find(described);
        double moment = MOMENT * described.duration();
        Scene scene = SceneBuilder.build(described.withDuration(moment));
        FrameSetup stage = new FrameSetup(camera, withTrails(scene, moment), scene.scenery(), "", "");
        FrameRenderer renderer = new FrameRenderer(stage, WIDTH, HEIGHT, 2);
        long count = Math.round(Math.max(described.output().frames().rate() * moment, 20));
        int[] last = new int[WIDTH * HEIGHT];
        FrameSink keep = (index, rgb) -> () -> System.arraycopy(rgb, 0, last, 0, last.length);
        try (FrameDrawer drawer = new FrameDrawer(renderer, List.of(keep))) {
            FrameObserver frames = new FrameObserver(stage.look().style(), count / moment, List.of((frame, state) -> {
                if (frame % count == 0) {               // the first, which decides sizes, and the last
                    drawer.write(frame, state);
                }
            }));
            scene.simulation().addObserver(frames);
            scene.simulation().run();
        }
        OutputFile.write(picture, PngEncoder.file(WIDTH, HEIGHT, last));
    }

    /** Adds trails if there are few particles, so that a still picture shows motion. */
    private static RenderOptions withTrails(Scene scene, double duration) {
        RenderOptions look = scene.description().drawing().look();
        ParticleStyle style = look.style();
        if (scene.system().getParticles().free().count() > MOST_TRAILS || style.kind() != ParticleStyle.Kind.BALLS
                || style.longestTrail() > 0) {
            return look;
        }
        return look.withStyle(style.withTrail(duration));
    }

    /**
     * @param folder the folder of the scenes
     * @return the page, in Markdown
     */
    public static String page(Path folder) {
        return SceneFiles.list(folder).stream().map(file -> row(SceneName.of(file), SceneReader.read(file,
                new StudentClasses()))).collect(Collectors.joining("", BEGINNING, KEYS + Reference.of(
                SceneFormat.SCENE, "###")));
    }

    private static String row(SceneName name, SceneDescription scene) {
        String words = String.join(" ", scene.values().get(SceneFormat.TEACHES).strip().split("\\s+"));
        String teaches = words.replace("|", "\\|");
        return ROW.formatted(name.whole(), scene.title(), PICTURES, teaches, scene.solver(),
                scene.title().replace("\"", "&quot;"));
    }
}
