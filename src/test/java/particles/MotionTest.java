package particles;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.scene.ShortRun;

/** A motion and its pieces, the sub-steps of adaptive solvers. */
class MotionTest {
    /** Notes times and heights at the ends of all pieces. */
    private static final class Pieces implements Observer {
        private final List<double[]> ends = new ArrayList<>();
        private int motions;
        private boolean adaptive;

        @Override
        public void moved(Motion motion) {
            motions++;
            adaptive = motion.isAdaptive();
            double[] state = motion.getStartState();
            double time = motion.getStartTime();
            for (int k = 0; k < motion.getPieces(); k++) {
                Motion piece = motion.getPiece(k);
                assertArrayEquals(state, piece.getStartState());
                assertEquals(time, piece.getStartTime());
                assertTrue(piece.getEndTime() > time, "piece " + k + " of " + motion.getPieces() + " takes time");
                state = piece.getEndState();
                time = piece.getEndTime();
                ends.add(new double[] {time, state[1]});
            }
            assertArrayEquals(motion.getEndState(), state);
            assertEquals(motion.getEndTime(), time);
        }
    }

    /** A ball that falls from 10 m, and bounces, in steps of 4 s. */
    private static Pieces fall(String solver) {
        ShortRun run = new ShortRun(solver + " exact 4 4", """
                particles: [{id: p, position: [0, 10, 0]}]
                rules: [ground: {restitution: 1}]
                """);
        Pieces pieces = new Pieces();
        run.getSimulation().addObserver(pieces);
        run.run();
        return pieces;
    }

    /** The path is a parabola, before the bounce and after; a tolerance of 1e-12 follows it in sub-steps. */
    @Test
    void thePiecesOfAMotionAreTheSubStepsUpToItsEnd() {
        Pieces pieces = fall("{'name':'dormand-prince','relativeTolerance':1e-12,'absoluteTolerance':1e-12}");
        double bounce = Math.sqrt(2 * 10 / 9.81);
        assertEquals(2, pieces.motions, "one bounce at " + bounce + " s");
        assertTrue(pieces.adaptive && pieces.ends.size() > 2, pieces.ends.size() + " pieces");
        for (double[] end : pieces.ends) {
            double time = end[0] <= bounce * (1 + 1e-12) ? end[0] : 2 * bounce - end[0];
            assertEquals(10 - 9.81 * time * time / 2, end[1], 1e-10);
        }
    }

    @Test
    void otherStepsAreOnePiece() {
        Pieces pieces = fall("euler");
        assertFalse(pieces.adaptive);
        assertEquals(pieces.motions, pieces.ends.size());
    }

    /** 600,000 numbers a state: two fit. Of a thousand, the one at 512 is left. */
    @Test
    void ofVeryManySubStepsSomeAreKept() {
        ParticleSystem system = Systems.row(100_000);
        Motion motion = new Motion();
        motion.begin(system);
        double[] state = new double[system.getStateSize()];
        for (int k = 1; k <= 1000; k++) {
            state[0] = k;
            system.subStepTaken(state, k);
        }
        system.incTime(1000);
        motion.end();
        assertEquals(2, motion.getPieces());
        assertEquals(512, motion.getPiece(0).getEndTime());
        assertEquals(512, motion.getPiece(0).getEndState()[0]);
        assertEquals(1000, motion.getPiece(1).getEndTime());
    }
}
