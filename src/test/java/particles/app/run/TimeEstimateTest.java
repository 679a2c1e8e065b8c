package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Test;
import particles.Motion;
import particles.Observer;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;

/** The time estimate printed before a run, with a fake clock. */
class TimeEstimateTest {
    private static SceneDescription scene(double duration) {
        return TestScenes.read("""
                title: a
                teaches: b
                solver: rk4
                deltaT: 0.001
                duration: %s
                particles:
                  - {id: bob, position: [0, 1, 0]}
                effects: [gravity]
                """.formatted(duration));
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
        return TimeEstimate.seconds(SceneBuilder.build(scene(1000)), steps, clock, 60_000);
    }

    @Test
    void theRestIsTakenToBeLikeTheLastStepsOfTheRehearsal() {
        assertEquals(1000, seconds(clock(1_000_000, Long.MAX_VALUE), 1_000_000), 1e-6);
        assertEquals(250, seconds(clock(1_000_000, 300), 1_000_000), 1e-6, "warm by then");
    }

    /** The first step ends only after the estimate was made: it is said that all 1000 steps take at least 2 s each. */
    @Test
    void aStepThatDoesNotEndIsNotWaitedFor() throws InterruptedException {
        Scene copy = SceneBuilder.build(scene(1));
        CountDownLatch estimated = new CountDownLatch(1);
        CountDownLatch ended = new CountDownLatch(1);
        copy.simulation().addObserver(new Observer() {
            @Override
            public void moved(Motion motion) {
                try {
                    estimated.await();
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
                ended.countDown();
            }
        });
        assertEquals(1000 * 0.02, TimeEstimate.seconds(copy, 1000, System::nanoTime, 20), 1e-12);
        estimated.countDown();
        ended.await();
    }

    @Test
    void whatEmittersWillMakeIsCounted() {
        SceneDescription fountain = TestScenes.read("""
                title: a
                teaches: b
                solver: rk4
                deltaT: 0.001
                duration: 3600
                particles: [{id: source, position: [0, 0, 0], fixed: true}]
                rules: [emitter: {id: jet, position: [0, 0, 0], speed: 1, rate: 10}]
                """);
        String line = TimeEstimate.of(fountain.withOutput(fountain.output().withoutFrames())).orElseThrow();
        assertTrue(line.endsWith(": 3600000 steps of up to 36001 particles"), line);
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
        assertEquals("this takes about 43 s: 10000 steps of 1 particle",
                TimeEstimate.line(42.1, 10_000, TimeEstimate.counted(1), 0));
        assertEquals("this takes about 6 min: 10000 steps of 7 particles and 251 pictures",
                TimeEstimate.line(343, 10_000, TimeEstimate.counted(7), 250.5));
        assertEquals("this takes about 3 h: 1e8 steps of 7 particles",
                TimeEstimate.line(10_000, 1e8, TimeEstimate.counted(7), 0));
        assertEquals("12 days", TimeEstimate.time(1e6));
    }

    @Test
    void nothingIsSaidOfWhatIsOverSoon() {
        assertEquals(Optional.empty(), TimeEstimate.of(scene(1)));
    }

    /** Ten hours of pictures: however fast the steps are, drawing takes its time. */
    @Test
    void picturesAreCountedToo() {
        assertTrue(TimeEstimate.of(scene(36_000)).orElseThrow().endsWith(" pictures"));
    }
}
