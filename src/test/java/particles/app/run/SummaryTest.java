package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertMatches;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.energy.EnergyRecorder;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;

/** The lines printed at the end of a run. */
class SummaryTest {

    /** The lines for a mass on a spring, x'' = -x from x = 1: 0.5 J for ever. */
    private static List<String> lines(String solver, double deltaT, double duration) {
        return spring(solver, deltaT, duration).lines(false);
    }

    private static Summary spring(String solver, double deltaT, double duration) {
        return summary(TestScenes.named("2").withSolver(solver).withDeltaT(deltaT).withDuration(duration));
    }

    private static List<String> lines(String text) {
        return summary(TestScenes.read(text)).lines(false);
    }

    private static Summary summary(SceneDescription described) {
        Scene scene = SceneBuilder.build(described);
        EnergyRecorder energy = new EnergyRecorder(scene.simulation(), scene.energyEstimate(), 1);
        energy.attachTo(scene.simulation(), List.of());
        scene.simulation().run();
        return new Summary("one \"spring\"", "ab12", "deltaT=0.5", scene, energy, 0.25);
    }

    /** A step as long as a twelfth of the fall, in which 64 particles begin to touch and slide. */
    @Test
    void stepsThatWereHalvedAreCounted() {
        String text = """
                title: A cloth on a ball
                teaches: Contact.
                solver: backward-euler
                deltaT: %s
                duration: 0.6
                shapes:
                  - cloth: {corner: [-1, 1.1, -1], across: [2, 0, 0], down: [0, 0, 2], columns: 8, rows: 8,
                            totalMass: 0.6, structural: {stiffness: 200}, shear: {stiffness: 100},
                            bend: {stiffness: 5}}
                effects: [gravity, drag: {coefficient: 0.0005}]
                rules:
                  - sphere: {centre: [0, 0, 0], radius: 1, restitution: 0, friction: {law: coulomb, coefficient: 0.4}}
                """;
        assertEquals("backward-euler failed at steps in contact, which were halved 2 times",
                lines(text.formatted(0.05)).get(2));
        assertStarts(lines(text.formatted(0.01)).get(2), "energy:");
    }

    /** A ball between two others, 0.1 mm from each: at 1 m/s it hits one of them 5,000 times a second. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1})
    void thousandsOfImpactsPerSecondAdviseSoftBalls(double speed) {
        String warning = lines("""
                title: A rattle
                teaches: Impacts.
                solver: rk4
                deltaT: 0.01
                duration: 0.05
                particles:
                  - {id: left, position: [-0.2001, 0, 0], fixed: true}
                  - {id: ball, position: [0, 0, 0], velocity: [%s, 0, 0]}
                  - {id: right, position: [0.2001, 0, 0], fixed: true}
                effects: []
                rules:
                  - collisions: {radius: 0.1, restitution: 1}
                """.formatted(speed)).stream().filter(line -> line.contains("'repulsion'")).findFirst().orElse("none");
        assertStarts(warning, speed < 1 ? "none" : "warning: 250 impacts");
    }

    /** Euler multiplies 0.5 J by 1 + h^2 = 1.25 in its only step; the energy scale is without that error. */
    @Test
    void runJsonHoldsEveryNumber() {
        assertEquals("""
                {
                  "version" : "0.1.0",
                  "scene" : "one \\"spring\\"",
                  "sceneSha256" : "ab12",
                  "set" : "deltaT=0.5",
                  "solver" : "euler",
                  "deltaT" : 0.5,
                  "duration" : 0.5,
                  "endTime" : 0.5,
                  "steps" : 1,
                  "evaluations" : 1,
                  "secondsTaken" : 0.25,
                  "energy" : {
                    "start" : 0.5,
                    "end" : 0.625,
                    "scale" : 0.5,
                    "relativeDrift" : 0.25,
                    "largestRelativeDrift" : 0.25,
                    "numericalError" : 0.125,
                    "relativeNumericalError" : 0.25,
                    "largestRelativeNumericalError" : 0.25,
                    "work" : { }
                  },
                  "java" : {
                    "version" : "VERSION",
                """.replace("VERSION", Runtime.version().toString()), spring("euler", 0.5, 0.5).json()
                .replaceFirst("(?s)    \"vendor.*", ""));
    }

    /** Euler multiplies the energy by 1 + h^2 in each step: 0.5 J (1.01)^100 = 1.352 J; 0.8524 J are its error. */
    @Test
    void aGrowingRunPrintsItsErrorAndAWarning() {
        List<String> lines = lines("euler", 0.1, 10);
        assertEquals(5, lines.size(), lines.toString());
        assertEquals("energy: 0.5 J at the start, 1.35 J at the end; largest change 0.852 J", lines.get(2));
        assertEquals("numerical error: at most 0.852 J (1.7 of the energy scale, 0.5 J)", lines.get(3));
        assertEquals("warning: the numerical error is 0.852 J, 1.7 times the energy; do not trust this motion."
                + " Try a smaller deltaT or another solver.", lines.get(4));
    }

    /** Implicit midpoint keeps the energy with any step; with 4.5 steps per period it is 0.16 m off after one. */
    @Test
    void stepsThatAreTooLongForTheVibrationAreToldThoughTheEnergyIsKept() {
        for (int steps : new int[] {1, 9}) {
            List<String> lines = lines("implicit-midpoint", 1.4, 1.4 * steps);
            assertEquals("warning: not resolved: the fastest visible vibration has fewer than 6 steps per period; try a"
                    + " smaller deltaT, or a solver that chooses its own sub-steps.", lines.get(4));
        }
        assertEquals(4, lines("implicit-midpoint", 0.5, 5).size());
        assertEquals(4, lines("radau", 1.4, 14).size(), "chooses its own sub-steps");
        List<String> damped = lines("backward-euler", 1.4, 14);
        assertTrue(damped.size() == 5 && damped.get(4).contains("numerical damping took"), damped.toString());
    }

    /** Both divide the energy by 1 + h^2 in each step: 0.5 J / (1.01)^100 = 0.185 J are left. */
    @ParameterizedTest
    @ValueSource(strings = {"backward-euler", "linearised-euler"})
    void energyLostByABackwardEulerMethodIsNumericalDamping(String solver) {
        List<String> lines = lines(solver, 0.1, 10);
        assertEquals(5, lines.size(), lines.toString());
        assertEquals("numerical error: at most 0.315 J (0.63 of the energy scale, 0.5 J), by numerical damping",
                lines.get(3));
        assertEquals("warning: numerical damping took 63 % of the energy scale; a smaller deltaT loses less.",
                lines.get(4));
    }

    /**
     * A hand shakes a block of 1 kg at its period, 1 s, with A = 2 cm. Its power is lost by numerical damping, gamma =
     * (2 pi)^2 deltaT per second, until the work of every period is: the loss grows without bound, the energy does not.
     */
    @Test
    void dampingOfMoreThanTheEnergyScaleIsToldAsEnergy() {
        String text = """
                title: A shaken block
                teaches: Damping takes the work of a hand.
                solver: backward-euler
                deltaT: 0.02
                duration: 20
                particles:
                  - {id: hand, position: [0, 0, 0], fixed: true}
                  - {id: block, position: [0, -1, 0], mass: 1}
                springs:
                  - {from: hand, to: block, stiffness: 39.47841760435743, restLength: 1}
                rules:
                  - shake: {particle: hand, amplitude: [0, 0.02, 0], period: 1}
                """;
        List<String> lines = lines(text);
        assertMatches(lines.get(4), "warning: numerical damping took \\d[.]\\d+ J, \\d\\d times the energy scale; a"
                + " smaller deltaT loses less.");
    }

    /** Both are right. Bulirsch-Stoer takes more than a swing at once, in which the ledger looks three times. */
    @Test
    void whatTheLedgerCannotResolveIsNotCalledWrong() {
        assertEquals(4, lines(TestScenes.shaken("radau", 0.19)).size());
        List<String> lines = lines(TestScenes.shaken("bulirsch-stoer", 0.19));
        assertEquals("note: the energy ledger cannot resolve this motion, as the sub-steps of bulirsch-stoer are too"
                + " long for it; the error may be the ledger's own. A smaller deltaT tells.", lines.get(4));
    }

    /** Bulirsch-Stoer is right to 3e-8 m in sub-steps of over a second; Simpson's rule leaves 4.6 J of 50 J. */
    @Test
    void anErrorOfTheLedgersOwnIntegralsIsCalledThat() {
        assertMatches(summary(TestScenes.named("3").withSolver("bulirsch-stoer").withDeltaT(2)).lines(false).get(3),
                "numerical error: at most 4\\.\\d+ J .*, mostly that of the ledger's own integrals");
        assertMatches(lines("dormand-prince", 0.1, 20).get(3), ".*scale, 0.5 J\\)");
    }

    /** 10 m/s cross the ball's 0.16 m, and more on the way to it, in less than four steps. */
    @Test
    void aForceThatAStepMaySkipIsReported() {
        assertMatches(lines("""
                title: A post
                teaches: A force narrower than a step.
                solver: verlet
                deltaT: 0.04
                duration: 1
                particles: [{id: b, position: [-1, 0.01, 0], velocity: [10, 0, 0]}]
                effects: [penaltySphere: {centre: [0, 0, 0], radius: 0.08, stiffness: 20000}]
                """).get(4), "warning: not resolved: penaltySphere may come and go within 0.028 s; try a deltaT of"
                + " 0.00701 s, or a solver that chooses its own sub-steps.");
    }

    @Test
    void aGoodRunDoesNotWarn() {
        List<String> lines = lines("rk4", 0.1, 20);
        assertEquals(4, lines.size(), lines.toString());
        assertMatches(lines.get(3), "numerical error: at most \\S+e-6 J .*");
    }

    @Test
    void aShortenedOnlyStepIsNamed() {
        assertEquals("the run is shorter than deltaT: its only step was 0.2 s long", lines("rk4", 0.5, 0.2).get(2));
        assertEquals(4, lines("rk4", 0.2, 0.2).size(), "it is as long as deltaT");
    }

    /** Files with holes take no room on the disk of the test, but have their length. */
    private static void write(Path file, long bytes) throws IOException {
        try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(bytes);
        }
    }

    @Test
    void runsOfMoreThanFiftyMegabytesSaySo(@TempDir Path folder) throws IOException {
        write(folder.resolve("trajectory.csv"), Summary.LARGE - 1);
        assertEquals(Optional.empty(), Summary.sizeNotice(folder, "-Pframes"));
        Files.createDirectories(folder.resolve("frames"));
        write(folder.resolve("frames/frame-00000.png"), 23_500_000);
        assertEquals(Optional.of("this run wrote 73 MB, 23 MB of it frames; -Pframes=false writes none"),
                Summary.sizeNotice(folder, "-Pframes"));
    }
}
