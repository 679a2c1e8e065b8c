package particles.lab;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.spec.ClassNames;

/** What a page asks for, it gets as text that scripts understand. */
class SessionTest {
    private static final String SCENE = """
            title: "A \\"spring\\""
            teaches: tests
            solver: rk4
            deltaT: 0.01
            duration: 1
            particles:
              - {id: wall, position: [0, 0, 0], fixed: true}
              - {id: bob, position: [2, 0, 0]}
            springs:
              - {from: wall, to: bob, stiffness: 100, restLength: 1}
            """;

    private final Session session = new Session(ClassNames.none());

    @Test
    void aSceneIsOpenedWithItsFacts() {
        String facts = session.open("x.yaml", SCENE, "", "", 0, "");
        assertHas(facts, "\"title\":\"A \\\"spring\\\"\"");
        // omega = 10 rad/s and RK4's limit on the imaginary axis is 2.8284
        assertHas(facts, "\"limit\":0.2828");
        assertHas(new Session(ClassNames.none()).open("x.yaml", SCENE, "euler", "", 0, ""), "\"limit\":0.0");
        assertEquals("[\"wall\",\"bob\"]", session.ids());
        float forever = Float.POSITIVE_INFINITY;
        assertArrayEquals(new float[] {1, 0, forever, 0, 0, forever, 0, 1, 1, 100}, session.structure());
    }

    @Test
    void mistakesAreTheReadersOwnLines() {
        assertEquals("{\"errors\":[\"x.yaml:3:9: unknown solver 'rk5'; did you mean 'rk4'?",
                session.open("x.yaml", SCENE.replace("rk4", "rk5"), "", "", 0, "")
                        .replaceFirst("'rk4'\\?.*", "'rk4'?"));
    }

    @Test
    void anotherSolverAndStepTakeTheSceneSPlace() {
        session.open("x.yaml", SCENE, "euler", "0.5", 0, "");
        session.advance(10, 1e4);
        assertHas(session.status(), "\"steps\":2,\"evaluations\":2,");
        assertHas(session.status(), "\"over\":true");
    }

    /** A method that is not finished. */
    public static final class Unfinished extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            throw new IllegalStateException("yet to be written");
        }
    }

    @Test
    void aSolverWithoutAnyStepIsToldInItsOwnWords() {
        assertEquals("yet to be written", assertThrows(IllegalStateException.class, () -> session.region(
                Unfinished.class.getName(), -1, 0, 1, 2, 2)).getMessage());
    }

    @Test
    void aBlowUpIsTold() {
        session.open("x.yaml", SCENE.replace("duration: 1", "duration: 100"), "euler", "0.5", 0, "");
        session.advance(100, 1e4);
        assertHas(session.status(), "\"failure\":\"euler stopped at t = ");
    }

    @Test
    void thePastIsSeenAgain() {
        session.open("x.yaml", SCENE, "", "", 0, "");
        float[] start = session.state();
        session.advance(1, 1e4);
        session.look(0.501);
        assertHas(session.status(), "\"steps\":50,\"evaluations\":200,");
        session.look(0);
        assertArrayEquals(start, session.state());
        // x = 1 + cos(10 t): a quarter of a period on, the velocity is -10 sin(1.57); last is the moment shown
        float[] positions = session.values(0, "bob", "", -1);
        assertEquals(102, positions.length);
        assertEquals(2f, positions[0]);
        assertEquals(2f, positions[101]);
        double velocity = -10 * Math.sin(1.6);
        assertEquals(velocity, session.values(3, "bob", "", -1)[16], 1e-4);
        assertEquals(-velocity, session.values(6, "bob", "", -1)[16], 1e-4);
        assertEquals(positions[16], session.values(7, "bob", "wall", -1)[16]);
        assertEquals(velocity * velocity / 2, session.values(9, "bob", "", -1)[16], 1e-2);      // kinetic, of 1 kg
        assertEquals(0.16f, session.values(-1, "", "", -1)[16]);
        assertTrue(Float.isNaN(session.values(0, "nobody", "", -1)[0]));
        assertTrue(Float.isNaN(session.values(100, "bob", "", -1)[0]));
    }

    @Test
    void aFailedRunStandsAtItsLastStateAndIsNotRunOn() {
        session.open("x.yaml", SCENE.replace("duration: 1", "duration: 100"), "euler", "0.5", 0, "");
        session.advance(0.25, 1e4);
        session.advance(100, 1e4);
        String status = session.status();
        String stopped = status.replaceFirst("(?s).*stopped at t = ([0-9.]+) s.*", "$1");
        assertHas(status, "{\"time\":" + stopped + ",\"reached\":" + stopped + ",");
        float[] last = session.state();
        session.advance(200, 1e4);
        assertArrayEquals(last, session.state());
        // its last steps, on straight lines
        session.between(0.75);
        float[] middle = session.state();
        session.look(0.5);
        float one = session.state()[6];
        session.look(1);
        assertEquals((one + session.state()[6]) / 2, middle[6], 1e-5);
        assertEquals(13, session.states(0.5).length / (Double.parseDouble(stopped) / 0.5 - 1));
    }

    @Test
    void aRunGoesOnAfterItsDurationWithTheSameSteps() {
        session.open("x.yaml", SCENE, "", "0.3", 0, "");
        session.setEndless(true);
        session.advance(2.05, 1e4);
        // the fourth step ends at the duration, 1, as ever
        float[] times = session.values(-1, "", "", -1);
        assertArrayEquals(new float[] {0, 0.3f, 0.6f, 0.9f, 1, 1.3f, 1.6f, 1.9f, 2, 2.3f},
                Arrays.copyOf(times, times.length - 1), 1e-6f);
        assertHas(session.status(), "\"over\":false");
        session.setEndless(false);
        session.advance(9, 1e4);
        assertHas(session.status(), "\"time\":3.0,");
        assertHas(session.status(), "\"over\":true");
    }

    @Test
    void aPullIsWorkFromItsFirstStepOn() {
        session.open("x.yaml", SCENE, "verlet", "0.001", 0, "");
        session.advance(0.1, 1e4);
        session.drag("bob", 3, 2, 0);
        session.advance(0.3, 1e4);
        session.drag("", 0, 0, 0);
        session.advance(0.5, 1e4);
        float[] errors = session.values(11, "", "", -1);
        assertHas(session.status(), "\"pointer (driven)\":");
        // measured 0.0015, of verlet; 0.98 if a pull begins after the solver has used the force before
        assertBelow(0.003, Math.abs(errors[500]));
    }

    @ParameterizedTest
    @CsvSource({"07-sliding-friction.yaml, slow middle fast, contact", "40-rigid-pendulum.yaml, pivot bob, rods",
            "43-rod-on-the-ground.yaml, left right, rods"})
    void readingTheForcesAfterEveryStepChangesNoBitOfARun(String file, String ids, String reaction)
            throws IOException {
        String text = Files.readString(Path.of("scenes", file));
        Session read = new Session(ClassNames.none());
        read.open(file, text, "", "", 0, "");
        session.open(file, text, "", "", 0, "");
        boolean acted = false;
        while (!session.status().contains("\"over\":true")) {
            for (String id : ids.split(" ")) {
                acted |= read.particle(id).contains('"' + reaction + '"');
            }
            read.step();
            session.step();
            assertArrayEquals(session.exactState(), read.exactState(), session.status());
        }
        assertTrue(acted);
    }
}
