package particles.output.frames;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.output.animation.Film;
import particles.output.animation.GifAnimation;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.view.Camera;

/** Each style of picture: springs, a surface with shadows, trails, glowing and wet particles, births. */
class ThreadsTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 90;
    private static final double RATE = 25;
    private static final double DURATION = 0.32;

    @TempDir
    Path top;

    @ParameterizedTest
    @ValueSource(strings = {"02", "09", "13", "20", "24", "25", "27", "28", "29", "42"})
    void everyFileHasTheSameBytesWithAnyNumberOfThreads(String name) throws IOException {
        Map<String, byte[]> one = draw(name, 1);
        assertEquals(11, one.size(), "9 frames, the animation and the film");
        Map<String, byte[]> five = draw(name, 5);
        assertEquals(one.keySet(), five.keySet());
        one.forEach((file, bytes) -> assertArrayEquals(bytes, five.get(file), file));
    }

    private Map<String, byte[]> draw(String name, int threads) throws IOException {
        SceneDescription description = SceneReader.read(SceneFiles.find(Path.of("scenes"), name));
        Scene scene = SceneBuilder.build(description.withDuration(DURATION));
        Camera camera = description.drawing().camera().orElseThrow();
        FrameSetup setup = new FrameSetup(camera, description.drawing().look(), scene.scenery(), "title", "caption");
        FrameRenderer renderer = new FrameRenderer(setup, WIDTH, HEIGHT, 2);
        Path path = top.resolve(name + "-" + threads);
        try (OutputFolder folder = OutputFolder.open(path, OutputFolder.FRAMES);
                FrameObserver frames = new FrameObserver(setup.look().style(), RATE, List.of(new FrameDrawer(renderer,
                        List.of(FrameSink.png(folder, WIDTH, HEIGHT),
                        new GifAnimation(folder, WIDTH, HEIGHT, WIDTH / 2, RATE),
                        new Film(folder, WIDTH, HEIGHT, RATE)), threads)))) {
            scene.simulation().addObserver(frames);
            scene.simulation().run();
        }
        Map<String, byte[]> files = new TreeMap<>();
        try (Stream<Path> all = Files.walk(path)) {
            for (Path file : all.filter(file -> file.toString().matches(".*\\.(png|gif|mp4)")).toList()) {
                byte[] bytes = Files.readAllBytes(file);
                boolean film = file.toString().endsWith(Film.FILE);
                files.put(path.relativize(file).toString(), film ? withoutDate(bytes) : bytes);
            }
        }
        assertTrue(files.containsKey("frames/frame-00008.png"));
        return files;
    }

    /** The part before a film's table of contents, which has the date. */
    private static byte[] withoutDate(byte[] film) {
        int end = new String(film, StandardCharsets.ISO_8859_1).lastIndexOf("moov");
        assertTrue(end > film.length / 2);
        return Arrays.copyOf(film, end);
    }
}
