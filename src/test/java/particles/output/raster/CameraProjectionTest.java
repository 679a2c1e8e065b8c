package particles.output.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import particles.law.Vector3;
import particles.view.Camera;

/** Projection of points into the picture. */
class CameraProjectionTest {
    private static final Vector3 UP = new Vector3(0, 1, 0);

    private static double[] project(CameraProjection view, Vector3 p) {
        CameraProjection.Place place = view.place(p);
        return new double[] {place.x(), place.y(), place.depth()};
    }

    private static Camera camera(boolean perspective) {
        return new Camera(new Vector3(0, 0, 4), Vector3.ZERO, UP, perspective, 90, 8);
    }

    /**
     * At distance 4 under 90 degrees the picture is 8 m high, as the orthographic one is everywhere: 100 pixels a
     * metre.
     */
    @Test
    void metresBecomePixels() {
        for (boolean perspective : new boolean[] {true, false}) {
            CameraProjection view = new CameraProjection(camera(perspective), 1200, 800);
            assertEquals(8, view.viewHeight, 1e-12);
            double[] middle = project(view, Vector3.ZERO);
            assertEquals(600, middle[0], 1e-9);
            assertEquals(400, middle[1], 1e-9);
            assertEquals(4, middle[2], 1e-12);
            double[] rightAndUp = project(view, new Vector3(1, 2, 0));
            assertEquals(700, rightAndUp[0], 1e-9);
            assertEquals(200, rightAndUp[1], 1e-9);
            double[] nearer = project(view, new Vector3(1, 0, 2));
            assertEquals(perspective ? 800 : 700, nearer[0], 1e-9);
        }
    }

    @Test
    void theRayThroughAProjectedPointMeetsThePoint() {
        Random random = new Random(715);
        for (int k = 0; k < 200; k++) {
            Camera camera = new Camera(random(random).times(9), random(random), UP, k % 2 == 0, 50, 3);
            CameraProjection view = new CameraProjection(camera, 640, 480);
            Vector3 point = random(random);
            double[] place = project(view, point);
            Vector3 met = view.ray(place[0], place[1]).at(place[2]);
            assertEquals(0, met.minus(point).length(), 2e-14, camera + " " + point);
        }
    }

    private static Vector3 random(Random random) {
        return new Vector3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
    }

    @Test
    void pointsBehindTheCameraAreNotDrawn() {
        CameraProjection view = new CameraProjection(camera(true), 100, 100);
        assertTrue(view.place(Vector3.ZERO).visible());
        assertFalse(view.place(new Vector3(0, 0, 4)).visible());
        assertFalse(view.place(new Vector3(0, 0, 5)).visible());
        assertTrue(view.nearness(1) > view.nearness(2));
        CameraProjection flat = new CameraProjection(camera(false), 100, 100);
        assertTrue(flat.nearness(1) > flat.nearness(2));
    }

    /** Every corner is in the picture, and one is near its edge: the camera is no farther away than needed. */
    @Test
    void framingShowsEverythingAndLittleMore() {
        Random random = new Random(715);
        for (int k = 0; k < 100; k++) {
            Vector3 low = random(random).times(20);
            Vector3 size = new Vector3(random.nextDouble() + 0.01, 3 * random.nextDouble() + 0.01, random.nextDouble());
            double aspect = k % 3 == 0 ? 0.6 : 16 / 9.0;
            CameraProjection view = new CameraProjection(Camera.around(low, low.plus(size), aspect),
                    (int) (aspect * 900), 900);
            double farthest = 0;
            for (int c = 0; c < 8; c++) {
                double[] place = project(view, new Vector3(low.x() + (c & 1) * size.x(),
                        low.y() + (c >> 1 & 1) * size.y(),
                        low.z() + (c >> 2) * size.z()));
                farthest = Math.max(farthest, Math.abs(2 * place[0] / view.width - 1));
                farthest = Math.max(farthest, Math.abs(2 * place[1] / view.height - 1));
            }
            assertEquals(0.74, farthest, 0.001, low + " " + size);
        }
    }
}
