package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.EulerSolver;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Simulation;
import particles.law.Vector3;

class ProgressTest {
    private final StringWriter out = new StringWriter();

    /** Runs 100 steps with a fake clock of the given wall-clock time. */
    private List<String> linesOf(double seconds) {
        AtomicLong nanos = new AtomicLong(123);
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, Vector3.ZERO, Vector3.ZERO, false);
        Simulation simulation = new Simulation(system, EulerSolver::new, 0.5, 50);
        simulation.addObserver(new Observer() {
            @Override
            public void moved(Motion motion) {
                nanos.addAndGet((long) (seconds * 1e7));
            }
        });
        simulation.addObserver(new Progress(new PrintWriter(out), 50, nanos::get));
        simulation.run();
        return out.toString().lines().toList();
    }

    @Test
    void aShortRunIsSilent() {
        assertEquals(List.of(), linesOf(1.9));
    }

    @Test
    void aLongRunPrintsItsProgress() {
        List<String> lines = linesOf(20);
        assertEquals("t = 5 s of 50 s, 10 %, about 18 s to go", lines.get(0));
        assertEquals("t = 10 s of 50 s, 20 %, about 16 s to go", lines.get(1));
        assertTrue(lines.size() >= 8 && lines.size() <= 10, lines.toString());
    }

    @Test
    void aVeryLongRunPrintsEveryTenSeconds() {
        List<String> lines = linesOf(1100);
        assertEquals(99, lines.size());         // a step takes 11 s, and after the last one there is nothing to say
    }
}
