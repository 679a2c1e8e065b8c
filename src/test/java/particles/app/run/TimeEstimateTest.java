package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Test;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.Overrides;
import particles.scene.format.SceneDescription;

/** What is said of a run before it begins, with a clock that the test turns. */
class TimeEstimateTest {
    private static SceneDescription scene(double duration) {
        return SceneReader.read("x.yaml", """
                title: a
                teaches: b
                solver: rk4
                deltaT: 0.001
                duration: %s
                particles:
                  - {id: bob, position: [0, 1, 0]}
                effects: [gravity]
                """.formatted(duration).getBytes(StandardCharsets.UTF_8));
    }

    /**
     * A clock on which each step takes so long; after the first spans it takes a quarter of that, as with a warm Java.
     */
    private static LongSupplier clock(long nanosPerStep, long slowSteps) {
        AtomicLong now = new AtomicLong();
        AtomicLong calls = new AtomicLong();
        return () -> now.addAndGet(calls.getAndIncrement() < slowSteps ? nanosPerStep : nanosPerStep / 4);
    }

    private static double seconds(LongSupplier clock, double steps) {
        return TimeEstimate.seconds(SceneBuilder.build(scene(1000), new Overrides()), steps, clock);
    }

    @Test
    void theRestIsTakenToBeLikeTheLastStepsOfTheRehearsal() {
        assertEquals(1000, seconds(clock(1_000_000, Long.MAX_VALUE), 1_000_000), 1e-6);
        assertEquals(250, seconds(clock(1_000_000, 300), 1_000_000), 1e-6, "warm by then");
    }

    @Test
    void aShortRunIsNotRehearsedToTheEnd() {
        AtomicLong calls = new AtomicLong();
        LongSupplier clock = clock(1_000_000, Long.MAX_VALUE);
        assertEquals(5, seconds(() -> {
            calls.incrementAndGet();
            return clock.getAsLong();
        }, 5_000), 1e-9);
        assertTrue(calls.get() < 110, "the first tenth of a second says enough: " + calls);
    }

    @Test
    void linesAreInTheUnitThatSuits() {
        assertEquals("this takes about 43 s: 10000 steps of 1 particle", TimeEstimate.line(42.1, 10_000, 1, 0));
        assertEquals("this takes about 6 min: 10000 steps of 7 particles and 251 pictures",
                TimeEstimate.line(343, 10_000, 7, 250.5));
        assertEquals("this takes about 3 h: 1e8 steps of 7 particles", TimeEstimate.line(10_000, 1e8, 7, 0));
        assertEquals("12 days", TimeEstimate.time(1e6));
    }

    @Test
    void nothingIsSaidOfWhatIsOverSoon() {
        assertEquals(Optional.empty(), TimeEstimate.of(scene(1), new Overrides(), true));
    }

    /** Ten hours of pictures: however fast the steps are, drawing takes its time. */
    @Test
    void picturesAreCountedToo() {
        assertTrue(TimeEstimate.of(scene(36_000), new Overrides(), true).orElseThrow().endsWith(" pictures"));
    }
}
