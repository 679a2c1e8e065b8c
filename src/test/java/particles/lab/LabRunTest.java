package particles.lab;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;

/** A run made a few steps at a time is the run, and moments between steps are those of its motion. */
class LabRunTest {
    private static Scene scene(String number, double deltaT) {
        return SceneBuilder.build(TestScenes.named(number).withDeltaT(deltaT).withDuration(2));
    }

    /** A spring, a ball that bounces, and a fountain that particles come from and go. */
    @ParameterizedTest
    @ValueSource(strings = {"2", "6", "27"})
    void slicesOfARunHaveTheBitsOfTheWhole(String number) {
        Scene whole = scene(number, 0.01);
        whole.simulation().run();
        Scene sliced = scene(number, 0.01);
        LabRun run = new LabRun(sliced);
        for (int i = 1; !run.isOver(); i++) {
            run.advance(0.037 * i, () -> false);
        }
        int size = whole.system().getStateSize();
        assertEquals(size, sliced.system().getStateSize());
        assertArrayEquals(Arrays.copyOf(whole.system().getOwnState(), size),
                Arrays.copyOf(sliced.system().getOwnState(), size));
        assertEquals(whole.system().getEvaluations(), sliced.system().getEvaluations());
    }

    @Test
    void momentsBetweenStepsAreInterpolatedWithoutAStep() {
        LabRun run = new LabRun(scene("1", 0.5));               // a parabola, which the cubic has exactly
        Scene fine = scene("1", 0.1);
        LabRun reference = new LabRun(fine);
        for (double time : new double[] {0.1, 0.2, 0.4}) {
            run.advance(time, () -> false);
            reference.advance(time, () -> false);
            assertEquals(time, run.getShown().time());
            assertEquals(1, run.getScene().simulation().getSteps());
            assertArrayEquals(reference.getShown().state(), run.getShown().state(), 1e-6f);       // single precision
        }
    }

    @Test
    void stepsEndWhenTimeIsUp() {
        LabRun run = new LabRun(scene("2", 0.01));
        run.advance(1, () -> true);
        assertEquals(1, run.getScene().simulation().getSteps());
        run.step();
        assertEquals(2, run.getScene().simulation().getSteps());
        assertEquals(0.02, run.getShown().time(), 1e-15);
    }

    @Test
    void energiesAddUpToTheTotal() {
        LabRun run = new LabRun(scene("5", 0.001));
        run.advance(1, () -> false);
        float[] energies = run.getShown().energies();
        double sum = 0;
        for (int i = 1; i < energies.length - 1; i++) {
            sum += energies[i];
        }
        assertTrue(energies[1] > 0);
        assertEquals(energies[0], sum, 1e-6 * Math.abs(energies[0]) + 1e-6);
    }
}
