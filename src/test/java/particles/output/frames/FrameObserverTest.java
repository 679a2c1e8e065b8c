package particles.output.frames;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Systems.rk4;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.film;
import static particles.output.SmallPictures.plain;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.ParticleSystem;
import particles.Simulation;
import particles.SimulationException;
import particles.Systems;
import particles.law.Vector3;
import particles.output.TestEffects;
import particles.output.files.OutputException;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.Scenery;

/** Frames at regular times, drawn in another thread. */
class FrameObserverTest {
    private static final int W = 64;
    private static final int H = 400;

    @TempDir
    Path top;

    /** Records each frame's number and the ball's height in it (pixels from the top). */
    private static final class Notes implements FrameSink {
        private final List<Integer> frames = new ArrayList<>();
        private final List<Double> heights = new ArrayList<>();
        private int closed;
        private OutputException failure;

        @Override
        public Runnable prepare(int index, int[] rgb) {
            return () -> add(index, rgb);
        }

        private void add(int index, int[] rgb) {
            if (failure != null && index == 3) {
                throw failure;
            }
            frames.add(index);
            double sum = 0;
            int count = 0;
            for (int p = 0; p < rgb.length; p++) {
                if ((rgb[p] >> 8 & 255) > 60 + (rgb[p] & 255)) {
                    sum += p / W + 0.5;
                    count++;
                }
            }
            heights.add(sum / count);
        }

        @Override
        public void close() {
            closed++;
        }
    }

    private static FrameRenderer renderer() {
        return renderer(ParticleStyle.STANDARD);
    }

    private static FrameRenderer renderer(ParticleStyle style) {
        RenderOptions look = plain(0x00ff00, 0.3, style);
        return new FrameRenderer(new FrameSetup(FRONT, look, Scenery.NONE, "", ""), W, H, Optional.empty());
    }

    /** Thrown up from y = -4 m with 8 m/s under 8 m/s^2: y = -4 + 8 t - 4 t^2, which Hermite's cubic gives exactly. */
    private static Simulation thrown(double deltaT, double duration) {
        ParticleSystem system = Systems.oneParticle(new Vector3(0, -4, 0), new Vector3(0, 8, 0));
        system.addEffect(TestEffects.gravity(system, 8));
        return rk4(system, deltaT, duration);
    }

    private static Notes watch(Simulation simulation, double fps) {
        Notes notes = new Notes();
        film(simulation, renderer(), fps, notes);
        return notes;
    }

    @Test
    void framesHaveTheirTimesAtAnyStep() {
        for (double deltaT : new double[] {0.001, 0.03, 0.7}) {
            Notes notes = watch(thrown(deltaT, 2), 25);
            assertEquals(IntStream.rangeClosed(0, 50).boxed().toList(), notes.frames, "deltaT " + deltaT);
            for (int k = 0; k <= 50; k++) {
                double t = k / 25.0;
                double y = -4 + 8 * t - 4 * t * t;
                // pixels, 40 a metre: measured 0.39, since the ball is darker below
                assertEquals(H / 2.0 - 40 * y, notes.heights.get(k), 0.7, "t = " + t);
            }
            assertEquals(1, notes.closed);
        }
    }

    /**
     * A fall from 3.24 m reaches y = 0 at t = 0.9 s, between two regular samples of the trail, at 0.75 s and 1 s, when
     * it is at 0.99 m and 0.68 m.
     */
    @Test
    void aTrailReachesTheBounce() {
        ParticleSystem system = Systems.oneParticle(new Vector3(-0.5, 3.24, 0), new Vector3(1, 0, 0));
        system.addEffect(TestEffects.gravity(system, 8));
        Simulation simulation = rk4(system, 0.1, 1);
        simulation.addRule(Systems.afterStep(moved -> {
            double[] s = moved.getOwnState();
            boolean below = s[1] < 1e-6 && s[4] < 0;
            s[4] = below ? -s[4] : s[4];
            return below;
        }));
        int[][] last = new int[1][];
        ParticleStyle trail = new ParticleStyle(ParticleStyle.Kind.BALLS, List.of(0), 2, false);
        film(simulation, renderer(trail), 1, (index, rgb) -> () -> last[0] = rgb.clone());
        int lowest = IntStream.range(0, last[0].length)
                .filter(p -> (last[0][p] >> 8 & 255) > 30 + (last[0][p] & 255)).max().orElseThrow() / W;
        assertEquals(H / 2.0, lowest, 2);
    }

    @Test
    void theLastTimeHasAFrameWhenItIsOnTheGrid() {
        assertEquals(8, watch(thrown(0.01, 0.7), 10).frames.size());         // 0.1 is no binary number
        assertEquals(8, watch(thrown(0.01, 0.75), 10).frames.size());
        assertEquals(1, watch(thrown(0.01, 0), 10).frames.size());
    }

    /** The clock may end early by round-off; a frame that is due later is not drawn. */
    @Test
    void theLastFrameIsDrawnDespiteRounding() {
        for (double end : new double[] {Math.nextDown(1.0), 0.999}) {
            Notes notes = new Notes();
            ParticleSystem system = thrown(0.1, 1).getSystem();
            try (FrameObserver frames = new FrameObserver(renderer(), 1, List.of(notes))) {
                frames.started(system);
                system.incTime(end);
                frames.finished(system);
            }
            assertEquals(end == 0.999 ? List.of(0) : List.of(0, 1), notes.frames);
        }
    }

    @Test
    void aFailureOfTheDrawingThreadReachesTheCallerOnce() {
        Notes notes = new Notes();
        notes.failure = new OutputException(top.resolve("frame"), "write", "the disk is full", null);
        OutputException thrown = assertThrows(OutputException.class,
                () -> film(thrown(0.01, 1), renderer(), 25, notes));
        assertSame(notes.failure, thrown);
        assertEquals(List.of(0, 1, 2), notes.frames);
        assertEquals(1, notes.closed);
    }

    private static LastSteps lastSteps(Simulation simulation) {
        LastSteps last = new LastSteps(FRONT, W, H);
        simulation.addObserver(last);
        return last;
    }

    /** At one frame a second the run has one frame; its two steps follow, the last one shown for 2 s. */
    @Test
    void theLastStepsOfARunThatEndsEarlyAreShownOneByOne() {
        Notes notes = new Notes();
        Simulation simulation = thrown(0.125, 1);
        simulation.getSystem().addEffect(TestEffects.failingAt(0.35));
        LastSteps last = lastSteps(simulation);
        FrameDrawer drawer = new FrameDrawer(renderer(), List.of(notes));
        try (FrameObserver frames = new FrameObserver(ParticleStyle.STANDARD, 1, List.of(drawer))) {
            simulation.addObserver(frames);
            assertThrows(SimulationException.class, simulation::run);
            drawer.replay(simulation.getSystem(), last, "blew up", 1);
        }
        assertEquals(List.of(0, 1, 2, 3, 4), notes.frames);
        double[] times = {0, 0, 0.125, 0.25, 0.25};
        for (int k = 0; k < times.length; k++) {
            double y = -4 + 8 * times[k] - 4 * times[k] * times[k];
            assertEquals(H / 2.0 - 40 * y, notes.heights.get(k), 0.7, "frame " + k);       // as above
        }
    }

    @Test
    void noStepIsKeptAfterEverythingLeftThePicture() {
        Simulation simulation = thrown(0.01, 3);        // falls below y = -5 m at t = 1 + sqrt(5)/2 = 2.118 s
        LastSteps last = lastSteps(simulation);
        simulation.run();
        List<LastSteps.Step> steps = last.steps();
        assertEquals(12, steps.size());
        for (int k = 0; k < 12; k++) {
            double t = 2.12 - 0.01 * (11 - k);
            assertEquals(t, steps.get(k).time(), 1e-9);
            assertEquals(-4 + 8 * t - 4 * t * t, steps.get(k).state()[1], 1e-9);
        }
    }
}
