package particles.output.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import particles.output.raster.CameraProjection.Place;

/** Triangles on samples. */
class RasterTest {

    private static Place place(double x, double y, double near) {
        return new Place(x, y, 1, 1, near, true);
    }

    private static void triangle(Raster raster, int[] rgb, Place... corners) {
        raster.triangle(new int[] {0, 1, 2}, 0, corners, rgb);
    }

    private static int red(Raster raster, int x, int y) {
        return raster.colour[y * raster.width + x] >> 16;
    }

    /** Triangles of a randomly distorted grid cover its square without a hole. */
    @Test
    void neighboursLeaveNoHoles() {
        Random random = new Random(715);
        int n = 12;
        Raster raster = new Raster(50, 50);
        Place[] places = new Place[(n + 1) * (n + 1)];
        int[] rgb = new int[places.length];
        for (int k = 0; k < places.length; k++) {
            int i = k % (n + 1);
            int j = k / (n + 1);
            boolean inside = i > 0 && i < n && j > 0 && j < n;
            places[k] = place(100.0 * i / n + (inside ? 6 * random.nextDouble() - 3 : 0),
                    100.0 * j / n + (inside ? 6 * random.nextDouble() - 3 : 0), 1);
            rgb[k] = 0xffffff;
        }
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                int a = j * (n + 1) + i;
                raster.triangle(new int[] {a, a + 1, a + n + 1}, 0, places, rgb);
                raster.triangle(new int[] {a + 1, a + n + 2, a + n + 1}, 0, places, rgb);
            }
        }
        for (int p = 0; p < raster.near.length; p++) {
            assertEquals(1, raster.near[p], "sample " + p % 100 + ", " + p / 100);
            assertEquals(0xffffff, raster.colour[p]);
        }
        raster.clear();
        for (float near : raster.near) {
            assertEquals(Float.NEGATIVE_INFINITY, near);
        }
    }

    @Test
    void coloursAndNearnessChangeEvenly() {
        Raster raster = new Raster(50, 50);
        triangle(raster, new int[] {0, 0xff0000, 0x00ff00}, place(0, 0, 0), place(100, 0, 1), place(0, 100, 0));
        for (int x = 0; x < 99; x++) {
            assertEquals(255 * (x + 0.5) / 100, red(raster, x, 0), 1);
            assertEquals((x + 0.5) / 100, raster.near[x], 1e-6);
        }
        assertEquals(255 * 0.505, raster.colour[50 * 100] >> 8 & 255, 1);
        assertEquals(Float.NEGATIVE_INFINITY, raster.near[60 * 100 + 60], "outside of the triangle");
    }

    @Test
    void theNearerTriangleWinsInAnyOrder() {
        for (int order = 0; order < 2; order++) {
            Raster raster = new Raster(50, 50);
            for (int k = 0; k < 2; k++) {
                boolean front = k == order;
                int near = front ? 2 : 1;
                int colour = front ? 0xff0000 : 0x0000ff;
                triangle(raster, new int[] {colour, colour, colour}, place(0, 0, near), place(100, 0, near),
                        place(0, 100, near));
            }
            assertEquals(0xff0000, raster.colour[10 * 100 + 10]);
        }
    }

    @Test
    void farOrNonFiniteShapesAreNotDrawn() {
        Raster raster = new Raster(50, 50);
        int[] rgb = {-1, -1, -1};
        triangle(raster, rgb, place(1e300, 1e300, 1), place(-1e300, 0, 1), place(0, -1e300, 1));
        triangle(raster, rgb, place(Double.NaN, 5, 1), place(1, 8, 1), place(2, 2, 1));
        triangle(raster, rgb, place(5, 5, 1), place(5, 5, 1), place(5, 5, 1));
        triangle(raster, rgb, place(0, 0, 1), place(9, 0, 1), new Place(0, 9, -1, 1, 1, false));
        for (float near : raster.near) {
            assertEquals(Float.NEGATIVE_INFINITY, near);
        }
        triangle(raster, rgb, place(-1e6, -1e6, 1), place(1e6, -1e6, 1), place(0, 1e6, 1));
        assertTrue(raster.firstColumn() == 0 && raster.endColumn() == 50 && raster.firstRow() == 0
                && raster.endRow() == 50);
        assertEquals(1, raster.near[0]);
    }

    /**
     * The colour of any triangle lies between those of its corners: round-off neither wraps it around nor lets it
     * leave their range.
     */
    @Test
    void coloursStayBetweenThoseOfTheCorners() {
        Random random = new Random(33);
        for (int k = 0; k < 2000; k++) {
            Raster raster = new Raster(50, 50);
            double size = Math.pow(10, 8 * random.nextDouble() - 2);
            double thickness = Math.pow(10, -6 * random.nextDouble());
            Place[] corners = new Place[3];
            for (int c = 0; c < 3; c++) {
                double x = size * (random.nextDouble() - 0.5);
                corners[c] = place(50 + x, 50 + x * (k % 7 - 3) + size * thickness * (random.nextDouble() - 0.5), 1);
            }
            int low = k % 2 == 0 ? 0 : 100;
            int high = k % 3 == 0 ? 255 : 180;
            triangle(raster, new int[] {low * 0x010101, high * 0x010101, low * 0x010101}, corners);
            for (int p = 0; p < raster.near.length; p++) {
                int colour = raster.colour[p];
                int red = colour >> 16;
                assertTrue(raster.near[p] < 0 || red >= low && red <= high, "triangle " + k + ": " + colour);
                assertEquals(red * 0x010101, colour);
            }
        }
    }
}
