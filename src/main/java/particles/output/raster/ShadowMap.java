package particles.output.raster;

import java.util.Arrays;
import java.util.List;
import particles.law.Plane;
import particles.view.Camera;

/**
 * Shadows: the scene as the lamp sees it, as a map of the part of each pixel that is covered, from 0 to 1, blurred for
 * soft edges.
 */
public final class ShadowMap {
    private static final int SIZE = 480;
    /** The width of what the lamp sees, in heights of the picture. */
    private static final double EXTENT = 4.5;
    /** Binomial weights make a smooth blur. */
    private static final float[] WEIGHTS = {1 / 64f, 6 / 64f, 15 / 64f, 20 / 64f, 15 / 64f, 6 / 64f, 1 / 64f};
    private static final int REACH = WEIGHTS.length / 2;

    private final RoundShapes shapes;
    /** The nearness of the ground. */
    private final float[] ground = new float[SIZE * SIZE];
    private final float[] coverage = new float[SIZE * SIZE];
    private final float[] work = new float[SIZE * SIZE];
    // the part of the map in which there may be shadows
    private int from;
    private int to;

    /**
     * @param view   the lamp's
     * @param planes those that bear the shadows; what lies below them casts none
     */
    ShadowMap(CameraProjection view, Lighting lighting, List<Plane> planes) {
        shapes = new RoundShapes(new Raster(SIZE, SIZE), view, lighting);
        Arrays.fill(ground, Float.NEGATIVE_INFINITY);
        for (Plane plane : planes) {
            for (int p = 0; p < ground.length; p++) {
                double depth = Backdrop.depth(plane, view.ray(Raster.SAMPLES * (p % SIZE + 0.5),
                        Raster.SAMPLES * (p / SIZE + 0.5)));
                ground[p] = Math.max(ground[p], (float) view.nearness(depth));
            }
        }
    }

    /**
     * @param camera     the camera of the picture
     * @param viewHeight the height of the picture at its target (m)
     * @return how the lamp sees the scene, in samples
     */
    static CameraProjection view(Lighting lighting, Camera camera, double viewHeight) {
        Camera lamp = new Camera(camera.target().plus(lighting.lamp), camera.target(), camera.up(), false, 0,
                EXTENT * viewHeight);
        return new CameraProjection(lamp, Raster.SAMPLES * SIZE, Raster.SAMPLES * SIZE);
    }

    /** @return draws what the lamp sees */
    public RoundShapes getShapes() {
        return shapes;
    }

    /** Removes all shadows. */
    public void clear() {
        shapes.raster().clear();
        Arrays.fill(coverage, 0);
        Arrays.fill(work, 0);
    }

    /** Makes the map once all shapes are drawn. */
    public void blur() {
        Raster raster = shapes.raster();
        from = SIZE * Math.max(REACH, raster.firstRow() - REACH) + REACH;
        to = SIZE * Math.min(SIZE - REACH, raster.endRow() + REACH) - REACH;
        for (int y = raster.firstRow(); y < raster.endRow(); y++) {
            for (int x = raster.firstColumn(); x < raster.endColumn(); x++) {
                coverage[y * SIZE + x] = raster.covered(x, y, ground[y * SIZE + x]) / 4f;
            }
        }
        blur(coverage, work, 1);
        blur(work, coverage, SIZE);
    }

    private void blur(float[] in, float[] out, int step) {
        for (int p = from; p < to; p++) {
            float sum = 0;
            for (int k = 0; k < WEIGHTS.length; k++) {
                sum += WEIGHTS[k] * in[p + (k - REACH) * step];
            }
            out[p] = sum;
        }
    }

    /** @return whether a point is in the map */
    static boolean contains(double column, double row) {
        return column > 1 && column < SIZE - 1 && row > 1 && row < SIZE - 1;
    }

    /** @return the interpolated coverage at a point of the map */
    float at(float column, float row) {
        float c = column - 0.5f;
        float r = row - 0.5f;
        int x = (int) c;
        int y = (int) r;
        float u = c - x;
        float v = r - y;
        int at = y * SIZE + x;
        if (at + SIZE < from || at >= to) {
            return 0;
        }
        return (1 - v) * ((1 - u) * coverage[at] + u * coverage[at + 1])
                + v * ((1 - u) * coverage[at + SIZE] + u * coverage[at + SIZE + 1]);
    }
}
