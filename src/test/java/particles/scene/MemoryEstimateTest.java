package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.scene.format.SceneDescription;
import particles.spec.messages.Problems;

/**
 * Tests the memory estimate. The smallest heaps (MiB) in which cloths with structural and shear springs ran, found by
 * bisection: 100 x 100 with rk4 31, backward-euler 39; 300 x 300 with rk4 106, with pictures 118, bulirsch-stoer 148;
 * 600 x 600 with rk4 less than 392. With implicit solvers, what was alive after a collection in the middle of a run
 * with damped springs: backward-euler 33, 119 and 276 on 100, 200 and 300 particles square, radau 80 and 341 on 100 and
 * 200; in a jelly of 22 x 22 x 22 43 and 95. The estimates lie above these, by less than a factor of two.
 */
class MemoryEstimateTest {
    private static final double MEGABYTE = 1 << 20;

    private static SceneDescription cloth(int side, String solver) {
        return read("solver: " + solver
                + "\nshapes:\n  - cloth: {corner: [-1, 1, 0], across: [2, 0, 0], down: [0, -1, 0], columns: "
                + side + ", rows: " + side + ", totalMass: 1, structural: {stiffness: 10}, shear: {stiffness: 10}}\n");
    }

    private static SceneDescription read(String text) {
        String head = "title: a\nteaches: b\ndeltaT: 0.01\nduration: 10\n";
        return TestScenes.read(head + text);
    }

    @ParameterizedTest
    @CsvSource(textBlock = """
            31,  100, rk4
            39,  100, backward-euler
            80,  100, radau
            119, 200, backward-euler
            341, 200, radau
            118, 300, rk4
            276, 300, backward-euler
            148, 300, bulirsch-stoer
            """)
    void estimatesLieAboveWhatWasMeasured(double measured, int side, String solver) {
        assertEquals(1.5 * measured, MemoryEstimate.of(cloth(side, solver)).bytes() / MEGABYTE, measured / 2);
    }

    @Test
    void aSceneThatDoesNotFitIsRefusedWithNumbers() {
        Problems problems = new Problems();
        RunLimits.checkMemory(cloth(300, "rk4"), 100 * MEGABYTE, problems);
        assertEquals(List.of("""
                x.yaml:7:3: the scene needs about 152 MiB of memory for 90000 particles and 358202 springs with rk4, \
                and Java may use 100 MiB; use fewer particles, or give Java more memory: JAVA_TOOL_OPTIONS=-Xmx1g"""),
                problems.lines());
        RunLimits.checkMemory(cloth(300, "rk4"), 153 * MEGABYTE, problems);
        assertEquals(1, problems.count());
    }

    /** A billion particles: no computer of a student has that much, and Java refuses to start with -Xmx745059g. */
    @Test
    void moreMemoryThanAComputerHasIsNotAdvised() {
        String text = "solver: rk4\nparticles:\n  - {id: source, position: [0, 0, 0], fixed: true}\nrules:\n"
                + "  - emitter: {id: spark, position: [0, 0, 0], speed: 1, rate: 1e8, lifetime: 100}\n";
        Problems problems = new Problems();
        RunLimits.checkMemory(read(text), 4096 * MEGABYTE, problems);
        assertEquals(List.of("x.yaml:1:1: the scene needs about 763000 MiB of memory for 1000000001 particles and 0"
                + " springs with rk4, and Java may use 4100 MiB; use fewer particles"), problems.lines());
    }

    /**
     * 64,000 points with trails of half a second, sampled 100 times a second: 63 samples were alive, 955 bytes a
     * particle; and 499 MiB after collections, with all else, where 250,000 had such trails.
     */
    @Test
    void trailsAreCounted() {
        String points = "solver: rk4\nlook: {particlesAs: points%s}\nshapes:\n  - jelly: {centre: [0, 0, 0],"
                + " size: [1, 1, 1],"
                + " columns: 63, rows: 63, layers: 63, totalMass: 1, surface: false}\n";
        double with = MemoryEstimate.of(read(points.formatted(", trail: 0.5"))).bytes();
        double without = MemoryEstimate.of(read(points.formatted(""))).bytes();
        assertEquals(955.0 * 63 * 63 * 63, with - without, 0.02 * (with - without));
        assertEquals(1, with / (499 * MEGABYTE), 0.1);
    }

    /**
     * 100 births a second: with a lifetime of half a second, those of half a second and one step (births come before
     * deaths); with an infinite one, those of the whole run.
     */
    @Test
    void emittedParticlesAreCounted() {
        String emitter = "solver: rk4\nparticles:\n  - {id: a, position: [0, 0, 0]}\nrules:\n"
                + "  - emitter: {id: drop, position: [0, 0, 0], speed: 1, rate: 100%s}\n";
        assertEquals(52, MemoryEstimate.of(read(emitter.formatted(", lifetime: 0.5"))).particles());
        assertEquals(1001, MemoryEstimate.of(read(emitter.formatted(""))).particles());
        assertEquals(2, MemoryEstimate.of(read(emitter.formatted("") + "  - kill: {point: [0, -1, 0]}\n")).particles());
    }
}
