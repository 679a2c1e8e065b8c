package particles.lab;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.lab.Frame.Structure;

/** The memory of moments seen stays within its limit, from the first moment to the latest. */
class HistoryTest {
    private static final int PARTICLES = 100;
    private static final long LIMIT = 1_000_000;
    private static final Structure STRUCTURE = new Structure(new String[PARTICLES], new float[3 * PARTICLES]);

    private static Frame frame(double time) {
        return new Frame(time, new float[6 * PARTICLES], new float[4], STRUCTURE, new Frame.Account(0, 0, Map.of()));
    }

    private static History filled(int moments, double step) {
        History history = new History(LIMIT);
        for (int i = 0; i < moments; i++) {
            if (history.wants(i * step)) {
                history.add(frame(i * step));
            }
            assertTrue(history.getBytes() <= LIMIT, history.getBytes() + " bytes");
        }
        return history;
    }

    @Test
    void everyMomentIsKeptWhileThereIsRoom() {
        assertEquals(100, filled(100, 0.1).after(-1).size());
    }

    @Test
    void aLongRunIsThinnedEvenly() {
        List<Frame> frames = filled(100_000, 0.01).after(-1);
        assertEquals(0, frames.get(0).time());
        double latest = frames.get(frames.size() - 1).time();
        assertAbove(990, latest, "the latest");
        DoubleSummaryStatistics gaps = IntStream.range(1, frames.size()).mapToDouble(i ->
                frames.get(i).time() - frames.get(i - 1).time()).summaryStatistics();
        assertTrue(gaps.getMax() <= 2 * gaps.getMin() + 1e-9, gaps.toString());
        assertAbove(180, frames.size());       // 376 fill the memory, and half of them stay
    }

    @Test
    void ofTwoMomentsAtOneTimeTheLaterIsKept() {
        History history = filled(3, 0.5);
        long bytes = history.getBytes();
        Frame later = frame(1);
        history.add(later);
        assertEquals(3, history.after(-1).size());
        assertSame(later, history.at(1));
        assertEquals(bytes, history.getBytes());
    }

    @Test
    void theLatestMomentBeforeATimeIsFound() {
        History history = filled(100, 0.5);
        assertEquals(0, history.at(-1).time());
        assertEquals(10, history.at(10).time());
        assertEquals(10, history.at(10.4).time());
        assertEquals(49.5, history.at(1e9).time());
    }
}
