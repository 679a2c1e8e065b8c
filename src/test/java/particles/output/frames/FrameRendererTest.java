package particles.output.frames;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.H;
import static particles.output.SmallPictures.W;
import static particles.output.SmallPictures.count;
import static particles.output.SmallPictures.middle;
import static particles.output.SmallPictures.picture;
import static particles.output.SmallPictures.renderer;
import static particles.output.SmallPictures.scenery;
import static particles.output.SmallPictures.spring;
import static particles.output.SmallPictures.state;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.law.Plane;
import particles.law.Vector3;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.painters.FrameState;
import particles.output.painters.SurfacePainter.IntactTriangles;
import particles.output.painters.VisibilityFilter;
import particles.view.Camera;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery;
import particles.view.Scenery.Surface;
import particles.view.SpringView.SpringList;

/** Pictures against computed values: positions, visibility and shadows. */
class FrameRendererTest {
    private static final RenderOptions LOOK = new RenderOptions(Visibility.ALWAYS, Visibility.ALWAYS,
            0.5, 0.1, new RenderOptions.Colours(0x00ff00, 0x000000, 0xff0000, 0x0000ff), ParticleStyle.STANDARD);

    private static int[] draw(FrameState state) {
        return renderer(FRONT, LOOK, Scenery.NONE).render(state);
    }

    private static boolean isGreen(int rgb) {
        return (rgb >> 8 & 255) > 60 + (rgb >> 16 & 255) && (rgb >> 8 & 255) > 60 + (rgb & 255);
    }

    /** A ball of radius 0.5 m at (2, 1) m: its pixels are a disc of 10 pixels around (200, 80). */
    @Test
    void aBallHasItsPositionAndSize() {
        int[] rgb = draw(state(2, 1, 0));
        int count = 0;
        double x = 0;
        double y = 0;
        for (int p = 0; p < rgb.length; p++) {
            if (isGreen(rgb[p])) {
                count++;
                x += p % W + 0.5;
                y += p / W + 0.5;
            }
        }
        assertEquals(200, x / count, 0.2);
        assertEquals(80, y / count, 0.2);
        assertEquals(Math.PI * 100, count, 25);         // the highlight is white and edges are mixed: measured 320
    }

    @Test
    void aNearerBallHidesAFartherOne() {
        FrameState state = state(0, 0, 1, 0, 0, 0);
        state.structure().fixed()[1] = true;
        int[] rgb = draw(state);
        assertTrue(isGreen(middle(rgb)));
        state.state()[2] = -1;
        rgb = draw(state);
        assertTrue((middle(rgb) & 0xff) < 90, "the fixed particle is black");
    }

    @Test
    void aSurfaceHasTwoSides() {
        Surface surface = new Surface(new int[] {0, 1, 2}, false);
        FrameRenderer renderer = renderer(FRONT, LOOK, scenery(surface));
        int front = middle(renderer.render(state(-4, -4, 0, 4, -4, 0, 0, 4, 0)));
        int back = middle(renderer.render(state(4, -4, 0, -4, -4, 0, 0, 4, 0)));
        assertTrue((front >> 16) > 150 && (front & 255) < 60, Integer.toHexString(front));
        assertTrue((back >> 16) < 60 && (back & 255) > 150, Integer.toHexString(back));
    }

    @Test
    void springsShowTheirStrain() {
        RenderOptions springsOnly = new RenderOptions(Visibility.NEVER, Visibility.ALWAYS, 0.5, 0.1,
                new RenderOptions.Colours(0, 0, 0, 0), ParticleStyle.STANDARD);
        double[][] middle = new double[2][];
        for (int k = 0; k < 2; k++) {
            int[] rgb = renderer(FRONT, springsOnly, Scenery.NONE)
                    .render(spring(k == 0 ? 7 : 5, 1, -3, 0, 0, 3, 0, 0));
            int[] background = picture(FRONT, springsOnly, Scenery.NONE);
            double red = 0;
            double blue = 0;
            for (int p = 0; p < H * W * 7 / 10; p++) {             // above the words and the scale
                if (rgb[p] != background[p]) {
                    red += rgb[p] >> 16 & 255;
                    blue += rgb[p] & 255;
                }
            }
            middle[k] = new double[] {red, blue};
        }
        assertTrue(middle[0][1] > 1.5 * middle[0][0], "compressed is blue");
        assertTrue(middle[1][0] > 1.5 * middle[1][1], "stretched is red");
    }

    /** A ball at rest touches the drawn ground, one below is hidden, and shadows fall on the ground. */
    @Test
    void theGroundHidesAndCarriesShadows() {
        Camera above = new Camera(new Vector3(0, 20, 20), Vector3.ZERO, new Vector3(0, 1, 0), false, 0, 10);
        FrameRenderer renderer = renderer(above, LOOK, scenery(Plane.ground(0)));
        int[] empty = renderer.render(state(0, -50, 0)).clone();
        assertEquals(0, count(empty, FrameRendererTest::isGreen), "a ball under the ground is seen");
        assertArrayEquals(empty, renderer.render(state(0, -2, 0)), "a shadow from below");
        int[] hovering = renderer.render(state(0, 1, 0)).clone();
        long green = count(hovering, FrameRendererTest::isGreen);
        assertAbove(250, green);
        long darker = IntStream.range(0, empty.length).filter(p -> !isGreen(hovering[p])
                && (hovering[p] >> 16 & 255) < 0.8 * (empty[p] >> 16 & 255)).count();
        assertBetween(60, 400, darker);      // measured 220
        assertEquals(green, count(renderer.render(state(0, 0, 0)), FrameRendererTest::isGreen), 25,
                "the ground cuts into a ball that rests on it");
    }

    /** A closed surface hides the springs inside, and those that begin on it; an open one those that it contains. */
    @Test
    void surfacesHideTheirOwnSprings() {
        RenderOptions beside = RenderOptions.STANDARD;
        VisibilityFilter open = new VisibilityFilter(beside, List.of(new Surface(new int[] {0, 1, 2}, false)));
        assertTrue(!open.particle(0) && open.particle(3));
        assertTrue(!open.spring(0, 1) && open.spring(0, 3) && open.spring(3, 4));
        VisibilityFilter closed = new VisibilityFilter(beside,
                List.of(new Surface(new int[] {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2}, false)));
        assertTrue(!closed.particle(3) && closed.particle(4));
        assertTrue(!closed.spring(0, 4) && closed.spring(4, 5));
        VisibilityFilter all = new VisibilityFilter(LOOK, List.of(new Surface(new int[] {0, 1, 2}, false)));
        assertTrue(all.particle(0) && all.spring(0, 1));
    }

    /**
     * A square of two triangles that share a diagonal: with its springs gone one by one it is drawn
     * until one has fewer than two.
     */
    @Test
    void aTornTriangleIsNotDrawn() {
        Surface cloth = new Surface(new int[] {0, 1, 2, 0, 2, 3}, true);
        double[] square = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
        IntactTriangles whole = new IntactTriangles(cloth);
        int[][] drawn = {{}, {0, 1, 2}, {0, 1, 2, 0, 2, 3}};            // with two springs, three, and all
        for (int springs = 2; springs <= 4; springs++) {
            FrameState torn = state(0, List.of(), new SpringList(Arrays.copyOf(new int[] {1, 0, 2, 3}, springs),
                    Arrays.copyOf(new int[] {0, 3, 1, 2}, springs), new double[springs], new double[springs]), square);
            assertArrayEquals(drawn[springs - 2], whole.in(torn), springs + " springs");
        }
        assertArrayEquals(cloth.triangles(),
                new IntactTriangles(new Surface(cloth.triangles(), false)).in(state(square)));
        assertArrayEquals(new int[] {0, 1, 2},
                new IntactTriangles(new Surface(cloth.triangles(), false)).in(state(Arrays.copyOf(square, 9))));
    }

    @Test
    void drawnSizesAreLimited() {
        FrameSetup stage = new FrameSetup(FRONT, LOOK, Scenery.NONE, "", "");
        assertThrows(IllegalArgumentException.class, () -> new FrameRenderer(stage, 0, 100, 2));
        assertThrows(IllegalArgumentException.class, () -> new FrameRenderer(stage, 100_000, 100_000, 2));
    }
}
