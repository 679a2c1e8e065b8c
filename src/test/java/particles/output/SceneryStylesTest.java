package particles.output;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.H;
import static particles.output.SmallPictures.W;
import static particles.output.SmallPictures.area;
import static particles.output.SmallPictures.curve;
import static particles.output.SmallPictures.look;
import static particles.output.SmallPictures.middle;
import static particles.output.SmallPictures.picture;
import static particles.output.SmallPictures.renderer;
import static particles.output.SmallPictures.scenery;
import static particles.output.SmallPictures.spring;
import static particles.output.SmallPictures.state;

import org.junit.jupiter.api.Test;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.output.frames.FrameRenderer;
import particles.output.painters.FrameState;
import particles.view.Camera;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery;
import particles.view.Scenery.CurveView;

/** Sizes and positions of drawn rods, wires and spheres. */
class SceneryStylesTest {
    /** A ball of radius r at distance d has the angular radius asin(r/d); it is drawn smaller by a bead's radius. */
    @Test
    void aSphereHasItsAngularSize() {
        Camera camera = new Camera(new Vector3(0, 0, 5), Vector3.ZERO, new Vector3(0, 1, 0), true, 60, 0);
        double focal = H / (2 * Math.tan(Math.PI / 6));
        FrameRenderer without = renderer(camera, look(ParticleStyle.Kind.BALLS, 0.2, 0), Scenery.NONE);
        int[] empty = without.render(state()).clone();
        Sphere ball = new Sphere(Vector3.ZERO, 1.2, false);
        double inset = 0.003 * 2 * 5 * Math.tan(Math.PI / 6);
        for (boolean bead : new boolean[] {false, true}) {
            FrameState state = bead ? state(0, 100, 0) : state();
            double r = 1.2 - (bead ? 0.2 : inset);
            int[] rgb = renderer(camera, look(ParticleStyle.Kind.BALLS, 0.2, 0), scenery(ball)).render(state);
            double seen = focal * r / Math.sqrt(25 - r * r);
            // edge pixels in full: measured 1.014, 1.022
            assertEquals(1, area(rgb, empty) / (Math.PI * seen * seen), 0.05);
        }
        int[] hollow = picture(camera, look(ParticleStyle.Kind.BALLS, 0.2, 0),
                scenery(new Sphere(Vector3.ZERO, 1.2, true)), 0, 0, 0);
        assertTrue((middle(hollow) & 255) > 120, "what is inside of a hollow is seen");
        int[] solid = picture(camera, look(ParticleStyle.Kind.BALLS, 0.2, 0), scenery(ball), 0, 0, 0);
        int[] alone = picture(camera, look(ParticleStyle.Kind.BALLS, 0.2, 0), scenery(ball), 0, 100, 0);
        assertEquals(middle(alone), middle(solid), "what is inside of a ball is not");
    }

    /** Rods are straight grey bars at any length, without a strain scale. */
    @Test
    void rodsAreBars() {
        RenderOptions look = new RenderOptions(Visibility.NEVER, Visibility.ALWAYS, 0.5, 0.1,
                new RenderOptions.Colours(0, 0, 0, 0), ParticleStyle.STANDARD);
        int[] empty = picture(FRONT, look, Scenery.NONE);
        int[] heights = new int[2];
        for (int k = 0; k < 2; k++) {
            int[] rgb = renderer(FRONT, look, Scenery.NONE)
                    .render(spring(6, k == 0 ? Double.POSITIVE_INFINITY : 1, -3, 0, 0, 3, 0, 0));
            for (int y = 0; y < 130; y++) {
                for (int x = 140; x < 180; x++) {
                    heights[k] += rgb[y * W + x] != empty[y * W + x] ? 1 : 0;
                }
            }
            int scale = 0;
            for (int p = 170 * W; p < rgb.length; p++) {
                scale += rgb[p] != empty[p] ? 1 : 0;
            }
            assertEquals(k == 1, scale > 100);
        }
        // 2 * 0.34 * 0.5 m * 20 pixels a metre * 40 columns = 272, and edge pixels, in full: measured 320; a coil has
        // 412
        assertEquals(272, heights[0], 50);
        assertTrue(heights[1] > 380, "a spring is no bar");
    }

    /** A ring of wire is drawn in its place; an infinite wire to the edge of the picture. */
    @Test
    void wiresFollowTheirCurves() {
        CurveView ring = curve(6 * Math.PI, u -> new Vector3(3 * Math.cos(u / 3), 3 * Math.sin(u / 3), 0));
        CurveView parabola = curve(Double.POSITIVE_INFINITY, u -> new Vector3(u, u * u / 16, 0));
        RenderOptions look = look(ParticleStyle.Kind.BALLS, 0.5, 0);
        int[] empty = picture(FRONT, look, Scenery.NONE);
        int[] first = picture(FRONT, look, scenery(ring));
        double mean = 0;
        int count = 0;
        for (int p = 0; p < first.length; p++) {
            if (first[p] != empty[p]) {
                double r = Math.hypot(p % W + 0.5 - 160, p / W + 0.5 - 100);
                assertEquals(60, r, 3.3, "farther from the ring than its wire is thick");     // 0.1 m is 2 pixels
                mean += r;
                count++;
            }
        }
        assertEquals(60, mean / count, 0.1);          // measured 60.05
        assertAbove(2 * Math.PI * 60 * 3, count);
        int[] second = picture(FRONT, look, scenery(parabola));
        for (int x = -7; x <= 7; x++) {
            int p = (int) (100 - 20 * x * x / 16.0) * W + 160 + 20 * x;
            assertTrue(second[p] != empty[p], "at " + x + " m");
        }
    }
}
