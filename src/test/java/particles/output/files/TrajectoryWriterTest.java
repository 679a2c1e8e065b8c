package particles.output.files;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.rk4;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntToLongFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.ParticleSystem;
import particles.Simulation;
import particles.StridedRecorder;
import particles.Systems;
import particles.law.Vector3;
import particles.output.TestEffects;

/** The trajectory file against the solver's states. */
class TrajectoryWriterTest {
    private static final String HEADER = "time,particle,x,y,z,vx,vy,vz";

    @TempDir
    Path top;

    /** Two particles, one thrown sideways, under gravity; one bounces by hand at the end of the third step. */
    private static Simulation thrown(double duration, boolean jump) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, new Vector3(0, 1, 0), new Vector3(0.3, 0, -0.0), false);
        system.addParticle("b, \"the\" second", 2, new Vector3(1.0 / 3, 2, 0), Vector3.ZERO, false);
        system.addEffect(TestEffects.gravity(system, 9.81));
        Simulation simulation = rk4(system, 0.1, duration);
        if (jump) {
            int[] steps = new int[1];
            simulation.addRule(Systems.afterStep(moved -> {
                boolean now = ++steps[0] == 3;
                moved.getOwnState()[4] = now ? 5 : moved.getOwnState()[4];
                return now;
            }));
        }
        return simulation;
    }

    private List<String> linesOf(Simulation simulation, String folder) throws IOException {
        return linesOf(simulation, particles -> 1, folder);
    }

    private List<String> linesOf(Simulation simulation, IntToLongFunction stride, String folder) throws IOException {
        try (OutputFolder out = OutputFolder.open(top.resolve(folder));
                TrajectoryWriter writer = new TrajectoryWriter(out, stride)) {
            simulation.addObserver(writer);
            simulation.run();
        }
        return Files.readAllLines(top.resolve(folder).resolve("trajectory.csv"));
    }

    /**
     * A particle is born in each of 1000 steps: written by the first number of particles it would be half a million
     * lines. Allowed are 5000 beside the first state and the last, of 1 and 1001 particles.
     */
    @Test
    void theFileStaysBelowItsLimitWhenParticlesAreBorn() throws IOException {
        ParticleSystem system = Systems.oneParticle(Vector3.ZERO, new Vector3(1, 0, 0));
        Simulation simulation = rk4(system, 0.125, 125);
        simulation.addRule(Systems.afterStep(grown -> {
            grown.addParticle("p" + grown.getParticles().count(), 1, Vector3.ZERO, Vector3.ZERO, false);
            return true;
        }));
        List<String> lines = linesOf(simulation, n -> TrajectoryWriter.strideFor(1000, n, 5000), "born");
        int most = 1 + 1 + 5000 + 1001;                 // the heading too
        assertTrue(lines.size() <= most, lines.size() + " lines");
        assertAbove(most / 2, lines.size(), "not much coarser than it may be");
    }

    @Test
    void theFileHasTheSolversStatesBitForBit() throws IOException {
        List<double[]> states = new ArrayList<>();
        List<Double> times = new ArrayList<>();
        Simulation simulation = thrown(0.55, false);
        simulation.addObserver(new StridedRecorder() {
            @Override
            protected void record(ParticleSystem system, double[] state, double time) {
                states.add(Arrays.copyOf(state, system.getStateSize()));
                times.add(time);
            }
        });
        List<String> lines = linesOf(simulation, "out");
        assertEquals(HEADER, lines.get(0));
        assertEquals(7, states.size());                         // five whole steps and a half one
        assertEquals(1 + 2 * states.size(), lines.size());
        for (int k = 0; k < states.size(); k++) {
            for (int i = 0; i < 2; i++) {
                String line = lines.get(1 + 2 * k + i);
                String id = i == 0 ? "a" : "\"b, \"\"the\"\" second\"";
                String start = times.get(k) + "," + id + ",";
                assertEquals(start, line.substring(0, start.length()));
                assertArrayEquals(Arrays.copyOfRange(states.get(k), 6 * i, 6 * i + 6), Stream.of(
                        line.substring(start.length()).split(",")).mapToDouble(Double::parseDouble).toArray(), line);
            }
        }
        assertEquals("0.0,a,0.0,1.0,0.0,0.3,0.0,-0.0", lines.get(1));
    }

    @Test
    void aStateIsWrittenAsRulesLeftIt() throws IOException {
        List<String> lines = linesOf(thrown(0.5, true), "out");
        String[] fields = lines.get(1 + 2 * 3).split(",");
        assertEquals("5.0", fields[6]);
    }

    @Test
    void aRunWithoutAStepHasOneState() throws IOException {
        assertEquals(3, linesOf(thrown(0, false), "out").size());
    }

    @Test
    void strideKeepsTheLinesBelowTheLimit() {
        assertEquals(1, TrajectoryWriter.strideFor(100, 10, 1000));
        assertEquals(2, TrajectoryWriter.strideFor(101, 10, 1000));
        assertEquals(1000, TrajectoryWriter.strideFor(1e6, 1, 1000));
        assertEquals(1, TrajectoryWriter.strideFor(0, 0, 1000));
    }
}
