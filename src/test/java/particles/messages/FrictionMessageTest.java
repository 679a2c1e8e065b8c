package particles.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.SimulationException;
import particles.scene.format.Overrides;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;

/** Where friction is why a solver finds no step, the line says so, and what it advises runs. */
class FrictionMessageTest {
    private static final Pattern OPTION = Pattern.compile("--(deltaT|solver)=([0-9a-z.-]+[0-9a-z])");

    private static Scene jelly(Overrides overrides) {
        return SceneBuilder.build(SceneReader.read(Path.of("scenes", "10-jelly-block.yaml")),
                overrides.with("duration", "0.6", "--duration"));
    }

    /** Scene 10 stops at 0.44 s with verlet, and at 0.462 s with implicit-midpoint. */
    @ParameterizedTest
    @ValueSource(strings = {"verlet", "implicit-midpoint"})
    @Tag("slow")
    void frictionIsNamedAndTheAdviceWorks(String solver) {
        Scene stops = jelly(new Overrides().with("solver", solver, "--solver"));
        SimulationException e = assertThrows(SimulationException.class, stops.simulation()::run);
        String line = FrictionMessage.of(stops, name -> "--" + name, e).orElseThrow();
        assertTrue(line.contains("Coulomb friction changes its direction too fast for " + solver), line);
        assertFalse(line.contains("damping"), line);
        Overrides advised = new Overrides();
        Matcher option = OPTION.matcher(line);
        while (option.find()) {
            advised = advised.with(option.group(1), option.group(2), option.group());
        }
        Scene runs = jelly(advised);
        runs.simulation().run();
        assertEquals(0.6, runs.system().getTime(), 1e-9);
    }

    /** A failure that is not the solver's has another line. */
    @Test
    void otherFailuresAreNotFrictions() {
        Scene scene = jelly(new Overrides());
        SimulationException e = new SimulationException(0, -1, "the clock does not move", null);
        assertTrue(FrictionMessage.of(scene, name -> "--" + name, e).isEmpty());
    }
}
