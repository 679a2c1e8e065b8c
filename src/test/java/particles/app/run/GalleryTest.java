package particles.app.run;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static particles.Texts.assertHas;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.scene.SceneFiles;
import particles.scene.SceneFiles.SceneName;

/** The gallery of scenes: its page matches the scenes, and each scene has its picture. */
class GalleryTest {
    private static final Path SCENES = Path.of("scenes");
    private static final long MOST_BYTES = 3_000_000;

    @Test
    void thePageMatchesTheScenes() throws IOException {
        assertEquals(GalleryCommand.page(SCENES), Files.readString(SCENES.resolve(GalleryCommand.FILE)),
                "scenes/README.md is out of date; gradle gallery writes it again");
    }

    @Test
    void eachSceneHasOnePictureAndAllAreSmall() throws IOException {
        Set<String> scenes = SceneFiles.list(SCENES).stream().map(file -> SceneName.of(file).whole() + ".png")
                .collect(Collectors.toCollection(TreeSet::new));
        Set<String> pictures = new TreeSet<>();
        long bytes = 0;
        try (Stream<Path> files = Files.list(SCENES.resolve(GalleryCommand.PICTURES))) {
            for (Path file : files.toList()) {
                pictures.add(file.getFileName().toString());
                bytes += Files.size(file);
                BufferedImage image = ImageIO.read(file.toFile());
                assertEquals(GalleryCommand.WIDTH, image.getWidth(), file.toString());
                assertEquals(GalleryCommand.HEIGHT, image.getHeight(), file.toString());
            }
        }
        assertEquals(scenes, pictures, "gradle gallery draws them again");
        assertBelow(MOST_BYTES, bytes, "0.5 million were measured for 32 scenes");
    }

    private static final String SCENE = """
            title: A thrown stone
            teaches: A parabola.
            solver: rk4
            deltaT: 0.01
            duration: 1
            particles:
              - {id: stone, position: [0, 0, 0], velocity: [3, 5, 0]}
            effects:
              - gravity
            look: {particleColour: "#ff0000", particleRadius: 0.1}
            camera: {position: [0.6, 0.6, 4], target: [0.6, 0.6, 0]}
            """;

    private static String gallery(ExitCode expected, Path folder) {
        return Screen.of(expected, List.of(new GalleryCommand(folder)), OptionStyle.SHELL, "gallery");
    }

    /** At 0.4 s, the stone is at (1.2, 1.2), right of the middle; its trail comes from the left. */
    @Test
    void thePictureShowsTheMotionSoFar(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("01-stone.yaml"), SCENE);
        gallery(ExitCode.DONE, folder);
        assertHas(Files.readString(folder.resolve("README.md")), "**A thrown stone**<br>A parabola.");
        BufferedImage image = ImageIO.read(folder.resolve("pictures/01-stone.png").toFile());
        int width = image.getWidth();
        IntSummaryStatistics red = IntStream.range(0, width * image.getHeight()).filter(p -> {
            int rgb = image.getRGB(p % width, p / width);
            return (rgb >> 16 & 255) > (rgb >> 8 & 255) + 60;
        }).map(p -> p % width).summaryStatistics();
        assertAbove(width / 2 + 20, red.getMax(), "the stone");
        assertBelow(width / 2, red.getMin(), "the beginning of its trail");
    }

    @Test
    void aSceneWithAMistakeIsNamedAndNothingIsWritten(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("01-stone.yaml"), SCENE.replace("duration: 1", "duration: long"));
        assertHas(gallery(ExitCode.BAD_INPUT, folder), "01-stone.yaml:5:");
        assertFalse(Files.exists(folder.resolve("README.md")));
        assertFalse(Files.exists(folder.resolve("pictures")));
    }
}
