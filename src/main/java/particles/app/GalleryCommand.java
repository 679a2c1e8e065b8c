package particles.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import particles.Camera;
import particles.Look;
import particles.Particles;
import particles.Style;
import particles.output.FrameObserver;
import particles.output.FrameRenderer;
import particles.output.LastFrame;
import particles.output.Stage;
import particles.scene.Overrides;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneDescription;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import picocli.CommandLine.Command;

/** {@code gradle gallery}: one small picture of each scene, and the page that shows them. */
@Command(name = "gallery", description = "Draws a small picture of each scene and writes scenes/README.md.")
final class GalleryCommand extends ProgramCommand {
    static final int WIDTH = 320;
    static final int HEIGHT = 180;
    /** A picture shows the motion after this part of the run, when most scenes are in full swing. */
    private static final double MOMENT = 0.4;
    /** More trails than this would hide what they show. */
    private static final int MOST_TRAILS = 6;

    private final Path folder;

    /** @param folder where the scenes are, and the page goes */
    GalleryCommand(Path folder) {
        this.folder = folder;
    }

    @Override
    void run(PrintWriter out) throws IOException {
        String page = GalleryPage.of(folder);           // a scene that cannot be read stops this before anything is drawn
        Path pictures = Files.createDirectories(folder.resolve(GalleryPage.PICTURES));
        for (Path file : SceneFiles.list(folder)) {
            String name = SceneName.of(file).whole();
            draw(file, pictures.resolve(name + ".png"));
            out.println(name);
            out.flush();
        }
        Files.writeString(folder.resolve(GalleryPage.FILE), page);
        out.println("the gallery: " + folder.resolve(GalleryPage.FILE));
    }

    private static void draw(Path file, Path picture) {
        SceneDescription described = SceneReader.read(file, new StudentClasses());
        Overrides whole = new Overrides();
        Camera camera = CameraFinder.find(SceneBuilder.build(described, whole), described, whole);
        double moment = MOMENT * described.duration();
        Scene scene = SceneBuilder.build(described, new Overrides().with("duration", Double.toString(moment), "the gallery"));
        Stage stage = new Stage(camera, withTrails(scene, moment), scene.scenery(), "", "");
        FrameRenderer renderer = new FrameRenderer(stage, WIDTH, HEIGHT, 2);
        double framesPerSecond = Math.max(scene.output().frameRate(), 20 / moment);
        try (FrameObserver frames = new FrameObserver(renderer, Math.round(framesPerSecond * moment) / moment,
                List.of(new LastFrame(picture, WIDTH, HEIGHT)))) {
            scene.simulation().addObserver(frames);
            scene.simulation().run();
        }
    }

    /** A still picture of few particles shows no motion without the way they came. */
    private static Look withTrails(Scene scene, double duration) {
        Look look = scene.look();
        Style style = look.style();
        Particles particles = scene.system().getParticles();
        long free = 0;
        for (int i = 0; i < particles.count(); i++) {
            free += particles.isFixed(i) ? 0 : 1;
        }
        if (free > MOST_TRAILS || style.kind() != Style.Kind.BALLS || style.trail() > 0) {
            return look;
        }
        return new Look(look.particles(), look.springs(), look.particleRadius(), look.strainRange(), look.particleColour(),
                look.fixedColour(), look.frontColour(), look.backColour(),
                new Style(style.kind(), style.ageColours(), duration, style.night()));
    }
}
