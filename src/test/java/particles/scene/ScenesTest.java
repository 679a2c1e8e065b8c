package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.Simulation;

/** Scenes are tests: every one is loaded and run, the long ones for their first steps. */
class ScenesTest {
    private static final int STEPS = 200;

    static List<Path> scenes() {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(file -> file.toString().endsWith(".yaml")).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void runs(Path file) {
        SceneDescription description = SceneReader.read(file);
        String steps = Double.toString(Math.min(description.duration(), STEPS * description.deltaT()));
        Scene scene = SceneBuilder.build(description, new Overrides().with("duration", steps, "-Pduration"));
        Simulation simulation = scene.simulation();
        simulation.run();
        assertTrue(simulation.getSteps() >= Math.min(STEPS, description.duration() / description.deltaT() - 1));
        assertEquals(Double.parseDouble(steps), scene.system().getTime(), 1e-9);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void isNumberedAndTellsEditorsItsSchema(Path file) throws IOException {
        assertTrue(file.getFileName().toString().matches("\\d\\d-[a-z0-9-]+\\.yaml"), file.toString());
        assertEquals("# yaml-language-server: $schema=scene.schema.json", Files.readAllLines(file).get(0));
    }
}
