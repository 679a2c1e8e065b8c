package particles.lab;

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
        String facts = session.open("x.yaml", SCENE, "", "", 0);
        assertHas(facts, "\"title\":\"A \\\"spring\\\"\"");
        // omega = 10 rad/s and RK4's limit on the imaginary axis is 2.8284
        assertHas(facts, "\"limit\":0.2828");
        assertHas(new Session(ClassNames.none()).open("x.yaml", SCENE, "euler", "", 0), "\"limit\":0.0");
        assertEquals("[\"wall\",\"bob\"]", session.ids());
        float forever = Float.POSITIVE_INFINITY;
        assertArrayEquals(new float[] {1, 0, forever, 0, 0, forever, 0, 1, 1, 100}, session.structure());
    }

    @Test
    void mistakesAreTheReadersOwnLines() {
        assertEquals("{\"errors\":[\"x.yaml:3:9: unknown solver 'rk5'; did you mean 'rk4'?",
                session.open("x.yaml", SCENE.replace("rk4", "rk5"), "", "", 0).replaceFirst("'rk4'\\?.*", "'rk4'?"));
    }

    @Test
    void anotherSolverAndStepTakeTheSceneSPlace() {
        session.open("x.yaml", SCENE, "euler", "0.5", 0);
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
        session.open("x.yaml", SCENE.replace("duration: 1", "duration: 100"), "euler", "0.5", 0);
        session.advance(100, 1e4);
        assertHas(session.status(), "\"failure\":\"euler stopped at t = ");
    }

    @Test
    void thePastIsSeenAgain() {
        session.open("x.yaml", SCENE, "", "", 0);
        float[] start = session.state();
        session.advance(1, 1e4);
        session.look(0.501);
        assertHas(session.status(), "\"steps\":50,\"evaluations\":200,");
        session.look(0);
        assertArrayEquals(start, session.state());
        float[] points = session.phase("bob", 0, -1);
        assertEquals(3 * 101, points.length);
        assertEquals(2f, points[1]);
        // x = 1 + cos(10 t): a quarter of a period on, the velocity is -10 sin(1.57)
        assertEquals(-10 * Math.sin(1.6), points[3 * 16 + 2], 1e-4);
    }

    @ParameterizedTest
    @CsvSource({"07-sliding-friction.yaml, slow middle fast, contact", "40-rigid-pendulum.yaml, pivot bob, rods",
            "43-rod-on-the-ground.yaml, left right, rods"})
    void readingTheForcesAfterEveryStepChangesNoBitOfARun(String file, String ids, String reaction)
            throws IOException {
        String text = Files.readString(Path.of("scenes", file));
        Session read = new Session(ClassNames.none());
        read.open(file, text, "", "", 0);
        session.open(file, text, "", "", 0);
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
