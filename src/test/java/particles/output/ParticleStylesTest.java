package particles.output;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.rk4;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.W;
import static particles.output.SmallPictures.area;
import static particles.output.SmallPictures.film;
import static particles.output.SmallPictures.look;
import static particles.output.SmallPictures.middle;
import static particles.output.SmallPictures.picture;
import static particles.output.SmallPictures.renderer;
import static particles.output.SmallPictures.scenery;
import static particles.output.SmallPictures.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.Simulation;
import particles.Systems;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.output.frames.FrameRenderer;
import particles.output.frames.TrailRecorder;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.output.painters.FrameState.TrailSample;
import particles.view.Camera;
import particles.view.ParticleStyle;
import particles.view.Scenery;
import particles.view.Scenery.Surface;
import particles.view.SpringView.SpringList;

/** Styles of particles: areas, positions and brightness against computed values. */
class ParticleStylesTest {
    /** The area in which the field of balls at z = 0 exceeds the level, which is what they cover seen along z. */
    private static double analyticArea(double radius, double... xs) {
        double step = 0.01;
        double area = 0;
        for (double x = -8; x < 8; x += step) {
            for (double y = -5; y < 5; y += step) {
                double field = 0;
                for (double middle : xs) {
                    double rest = Math.max(0, 1 - ((x - middle) * (x - middle) + y * y) / (4 * radius * radius));
                    field += rest * rest * rest;
                }
                area += field >= 0.421875 ? step * step : 0;        // (3/4)^3, the field where a single ball ends
            }
        }
        return area;
    }

    /** One ball, two that touch, two that merge as they are less than 2.54 radii apart, two that are farther apart. */
    @Test
    void blobsCoverTheLevelSetOfTheirField() {
        double radius = 1.5;
        int[] empty = picture(FRONT, look(ParticleStyle.Kind.BLOBS, radius, 0), Scenery.NONE);
        for (double distance : new double[] {0, 1.5, 3, 3.75, 3.9, 6}) {
            double[] xs = distance == 0 ? new double[] {0} : new double[] {-distance / 2, distance / 2};
            FrameState state = distance == 0 ? state(0, 0, 0) : state(xs[0], 0, 0, xs[1], 0, 0);
            int[] rgb = renderer(FRONT, look(ParticleStyle.Kind.BLOBS, radius, 0), Scenery.NONE).render(state);
            double expected = 400 * analyticArea(radius, xs);
            if (distance == 0) {
                assertEquals(400 * Math.PI * radius * radius, expected, 1);
            }
            // the chords of 3.5 cells to the radius cut off what pixels that count in full add; the neck at 3.75 m is
            // the
            // worst: measured 0.9895 there, 0.997 to 1.001 elsewhere
            assertEquals(1, area(rgb, empty) / expected, distance == 3.75 ? 0.025 : 0.01, "distance " + distance);
        }
    }

    /** The light that a particle adds falls from its birth to its death, and two add up to nearly twice one. */
    @Test
    void aGlowFadesWithAge() {
        FrameRenderer renderer = renderer(FRONT, look(ParticleStyle.Kind.GLOW, 1, 0), Scenery.NONE);
        int[] dark = renderer.render(state()).clone();
        double before = Double.POSITIVE_INFINITY;
        for (int k = 0; k <= 20; k++) {
            FrameState state = state(3 + 0.1 * k, List.of(), SpringList.NONE, 0, 0, 0);
            state.structure().births()[0] = 3;
            state.structure().deaths()[0] = 5;
            double light = light(renderer.render(state), dark);
            assertBelow(before, light, "age " + k);
            before = light;
        }
        assertEquals(0, before, "nothing is left at the end");
        FrameState immortal = state(1e6, List.of(), SpringList.NONE, 0, 0, 0);
        immortal.structure().deaths()[0] = Double.POSITIVE_INFINITY;
        double one = light(renderer.render(immortal), dark);
        assertAbove(50_000, one, "who does not die of age does not fade");
        FrameState two = state(0, 0, 0, 0, 0, 1);
        Arrays.fill(two.structure().deaths(), Double.POSITIVE_INFINITY);
        double both = light(renderer.render(two), dark);
        assertBetween(1.7 * one, 2 * one, both);       // measured 1.81: the film saturates
    }

    private static double light(int[] rgb, int[] dark) {
        double light = 0;
        for (int p = 0; p < 150 * W; p++) {              // above the words
            for (int shift = 0; shift < 24; shift += 8) {
                int more = (rgb[p] >> shift & 255) - (dark[p] >> shift & 255);
                assertTrue(more >= 0, "light makes nothing darker");
                light += more;
            }
        }
        return light;
    }

    /** A ball hides a spot of light behind it, but not one in front. */
    @Test
    void aNearerBallHidesAGlow() {
        FrameRenderer renderer = renderer(FRONT, look(ParticleStyle.Kind.GLOW, 3, 0), Scenery.NONE);
        int[] alone = new int[2];
        for (int k = 0; k < 2; k++) {
            FrameState state = state(0, 0, 0, 0, 0, k == 0 ? -5 : 5);
            state.structure().fixed()[0] = true;
            state.structure().deaths()[1] = Double.POSITIVE_INFINITY;
            alone[k] = middle(renderer.render(state)) >> 16 & 255;
        }
        assertTrue(alone[0] < 45 && alone[1] > 95, alone[0] + " behind, " + alone[1] + " in front");
    }

    /** In a perspective view points have the same size at any distance, unlike balls. */
    @Test
    void pointsHaveTheSameSizeAtAnyDistance() {
        Camera camera = new Camera(new Vector3(0, 0, 10), Vector3.ZERO, new Vector3(0, 1, 0), true, 40, 0);
        double[][] areas = new double[2][2];
        for (ParticleStyle.Kind kind : List.of(ParticleStyle.Kind.POINTS, ParticleStyle.Kind.BALLS)) {
            FrameRenderer renderer = renderer(camera, look(kind, 0.5, 0), Scenery.NONE);
            int[] empty = renderer.render(state()).clone();
            for (int k = 0; k < 2; k++) {
                areas[kind.ordinal()][k] = area(renderer.render(state(0.013, 0.021, k == 0 ? 5 : -20)), empty);
            }
        }
        assertEquals(areas[1][0], areas[1][1], 1);                               // two or three pixels
        // the square of 6 is 36; measured 32
        assertAbove(20 * areas[0][1], areas[0][0]);
    }

    /** A moving particle has a trail that fades evenly over its duration. */
    @Test
    void aTrailFollowsThePathAndFades() {
        ParticleSystem system = Systems.oneParticle(new Vector3(-6, 0.525, 0), new Vector3(4, 0, 0));
        Simulation simulation = rk4(system, 0.003, 3);
        FrameRenderer renderer = renderer(FRONT, look(ParticleStyle.Kind.BALLS, 0.25, 2), Scenery.NONE);
        int[] empty = picture(FRONT, look(ParticleStyle.Kind.BALLS, 0.25, 2), Scenery.NONE);
        List<int[]> frames = new ArrayList<>();
        film(simulation, renderer, 10, (index, rgb) -> () -> frames.add(rgb.clone()));
        assertEquals(31, frames.size());
        int[] last = frames.get(30);                    // at x = 6 m: the trail begins at -2 m
        double before = -1;
        for (int x = 0; x < 14; x++) {
            int column = 160 - 60 + 20 * x / 2;         // from -3 m in steps of 0.5 m
            int strongest = 0;
            for (int y = 80; y < 100; y++) {
                int p = y * W + column;
                strongest = Math.max(strongest, (empty[p] >> 16 & 255) - (last[p] >> 16 & 255));
            }
            double share = Math.max(0, (-3 + 0.5 * x + 2) / 8);
            double full = (empty[89 * W + column] >> 16 & 255) - 0x33;
            assertEquals(0.85 * share * full, strongest, 3, "at " + (-3 + 0.5 * x) + " m");    // measured 0.94
            assertTrue(share == 0 || strongest > before);
            before = strongest;
        }
    }

    /** Particles keep their trails when others are removed and indices change. */
    @Test
    void trailsFollowParticlesNotIndices() {
        ParticleSystem system = new ParticleSystem();
        for (int k = 0; k < 3; k++) {
            system.addParticle("p" + k, 1, new Vector3(k, 0, 0), Vector3.ZERO, false);
        }
        TrailRecorder trails = new TrailRecorder(1, 25);
        Particles particles = system.getParticles();
        trails.take(0, system.getOwnState(), particles);
        system.removeParticles(new boolean[] {true, false, false});
        system.addParticle("new", 1, new Vector3(9, 0, 0), Vector3.ZERO, false);
        FrameStructure structure = FrameStructure.of(system, List.of());
        trails.take(0.01, system.getOwnState(), particles);
        trails.take(0.02, system.getOwnState(), particles);
        FrameState state = new FrameState(0.02, system.getOwnState(), structure, trails.samples(), List.of());
        Vector3 one = new Vector3(1, 0, 0);
        assertEquals(List.of(one, one, one), state.path(0), "p1");
        assertEquals(2, state.path(2).size(), "the new one");
        assertSame(trails.samples().get(0).ids(), trails.samples().get(1).ids(), "nobody is born or removed");
        for (int k = 3; k < 400; k++) {
            trails.take(0.01 * k, system.getOwnState(), particles);
        }
        int regular = trails.samples().size();
        assertTrue(trails.samples().get(regular - 1).time() <= 2.99 && regular < 110, "the old ones are forgotten");
        for (int k = 0; k < 1000; k++) {
            trails.takeCorner(3.99, system.getOwnState(), particles);
        }
        assertEquals(125, trails.samples().size(), "of which " + regular + " are regular");
        assertEquals(Double.POSITIVE_INFINITY, new TrailRecorder(0, 25).getNextTime(),
                "who wants no trails asks for no time");
    }

    /** Particles of a blown-up run can be drawn in every style. */
    @Tag("slow")
    @Test
    void extremeNumbersCanBeDrawnInEveryStyle() {
        double huge = 1e200;
        for (ParticleStyle.Kind kind : ParticleStyle.Kind.values()) {
            TrailSample before = new TrailSample(-0.5, new float[] {1e30f, Float.NaN, 0, 0, 0,
                Float.POSITIVE_INFINITY, 1, 2, 3, 4, 5, 6, 7, 8, 9}, new String[] {"p0", "p1", "p2", "p3", "p4"});
            SpringList springs = new SpringList(new int[] {0, 1, 2, 3}, new int[] {1, 2, 3, 4},
                    new double[] {1, 0, 1, 1}, new double[4]);
            FrameState state = state(0, List.of(before), springs, huge, -huge, huge, Double.NaN, 0, 0,
                    Double.MAX_VALUE, 0, 1e9, 0, 0, 0, 1e12, 0, -3);
            System.arraycopy(new double[] {0, Double.NaN, 1, Double.POSITIVE_INFINITY, 1}, 0,
                    state.structure().deaths(), 0, 5);
            for (boolean perspective : new boolean[] {true, false}) {
                Camera camera = new Camera(new Vector3(0, 3, 9), Vector3.ZERO, new Vector3(0, 1, 0), perspective, 40,
                        9);
                Scenery scenery = scenery(new Surface(new int[] {0, 1, 2, 2, 3, 4, 7, 8, 9}, false), Plane.ground(0),
                        new Sphere(new Vector3(50, 0, 0), 1, true));
                int[] empty = picture(camera, look(kind, 0.5, 1), scenery);
                int[] rgb = renderer(camera, look(kind, 0.5, 1), scenery).render(state);
                assertTrue(middle(rgb) != middle(empty), kind + ": the one at the origin");
            }
        }
    }
}
