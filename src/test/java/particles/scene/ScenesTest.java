package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.Simulation;
import particles.effects.springs.SpringRates;
import particles.scene.format.SceneDescription;

/** Every scene is loaded and run, long ones for their first steps. */
class ScenesTest {
    private static final int STEPS = 100;

    @ParameterizedTest
    @MethodSource("particles.scene.TestScenes#files")
    void everySceneRuns(Path file) {
        SceneDescription description = SceneReader.read(file);
        double duration = Math.min(description.duration(), STEPS * description.deltaT());
        Scene scene = SceneBuilder.build(description.withDuration(duration));
        Simulation simulation = scene.simulation();
        simulation.run();
        assertTrue(simulation.getSteps() >= Math.min(STEPS, description.duration() / description.deltaT() - 1));
        assertEquals(duration, scene.system().getTime(), 1e-9);
    }

    @ParameterizedTest
    @MethodSource("particles.scene.TestScenes#files")
    void everySceneIsNumberedAndNamesItsSchema(Path file) throws IOException {
        assertTrue(file.getFileName().toString().matches("\\d\\d-[a-z0-9-]+\\.yaml"), file.toString());
        assertEquals("# yaml-language-server: $schema=scene.schema.json", Files.readAllLines(file).get(0));
    }

    /** Bounds for any motion: at most 0.69 of the imaginary limit, the flag's, and 0.993 of the real one, jelly's. */
    @ParameterizedTest
    @MethodSource("particles.scene.TestScenes#files")
    void stepsAreShortEnoughForTheScenesSprings(Path file) {
        Scene scene = SceneBuilder.build(SceneReader.read(file));
        SolverInfo solver = SolverCatalog.info(scene.description().solver());
        double deltaT = scene.simulation().getDeltaT();
        SpringRates rates = SpringRates.of(scene.springs(), scene.system().getParticles());
        if (solver.imaginaryLimit() == 0 && rates.omega() > 0) {
            assertEquals("11-euler-spiral.yaml", file.getFileName().toString(), "only this one shows growth");
            return;
        }
        assertTrue(rates.omega() * deltaT <= solver.imaginaryLimit(), "omega deltaT = " + rates.omega() * deltaT);
        if (!Double.isNaN(solver.realLimit())) {
            assertTrue(rates.dampingRate() * deltaT <= solver.realLimit(), "rate = " + rates.dampingRate());
        }
    }
}
