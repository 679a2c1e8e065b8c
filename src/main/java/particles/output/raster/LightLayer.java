package particles.output.raster;

import java.util.Arrays;

/** A layer of added light over a picture that saturates towards white: c becomes 255 - (255 - c) exp(-light). */
public final class LightLayer {
    private static final int STEPS_PER_UNIT = 256;
    private static final double MOST = 8;
    /** Where the channels of a colour are: red, green, blue. */
    private static final int[] SHIFTS = {16, 8, 0};

    private final int width;
    private final int height;
    /** Red, green, blue a pixel. */
    private final float[] light;
    private final float[] passed = new float[(int) (MOST * STEPS_PER_UNIT) + 1];
    private Foreground foreground;

    /** Creates a layer for pictures of this size (pixels). */
    public LightLayer(int width, int height) {
        this.width = width;
        this.height = height;
        light = new float[3 * width * height];
        for (int k = 0; k < passed.length; k++) {
            passed[k] = (float) Math.exp(-(double) k / STEPS_PER_UNIT);
        }
    }

    /** Clears the layer; {@code foreground} is what hides the light that is added next. */
    public void clear(Foreground foreground) {
        this.foreground = foreground;
        Arrays.fill(light, 0);
    }

    /**
     * Adds a round spot with brightness (1 - d&sup2;/r&sup2;)&sup2;, where nothing nearer hides it.
     *
     * @param at         the place of the middle
     * @param radius     r, in pixels
     * @param rgb        its colour
     * @param brightness the brightness of its centre; 1 turns black into most of the colour
     */
    public void spot(CameraProjection.Place at, double radius, int rgb, double brightness) {
        double x = at.x();
        double y = at.y();
        int x0 = Raster.first(x - radius, 0);
        int x1 = Raster.last(x + radius, width - 1);
        int y0 = Raster.first(y - radius, 0);
        int y1 = Raster.last(y + radius, height - 1);
        float[] colour = new float[3];
        for (int c = 0; c < 3; c++) {
            colour[c] = (float) (brightness * (rgb >> SHIFTS[c] & 255) / 255);
        }
        for (int py = y0; py <= y1; py++) {
            double dy = (py + 0.5 - y) / radius;
            for (int px = x0; px <= x1; px++) {
                double dx = (px + 0.5 - x) / radius;
                double rest = 1 - dx * dx - dy * dy;
                int p = py * width + px;
                if (rest > 0 && foreground.shows(at.near(), px, py)) {
                    float share = (float) (rest * rest);
                    for (int c = 0; c < 3; c++) {
                        light[3 * p + c] += share * colour[c];
                    }
                }
            }
        }
    }

    /** Brightens a picture. */
    public void addTo(int[] pixels) {
        for (int k = 0; k < light.length; k++) {
            if (light[k] > 0) {
                int shift = SHIFTS[k % 3];
                int channel = pixels[k / 3] >> shift & 255;
                pixels[k / 3] += brighter(channel, light[k]) - channel << shift;
            }
        }
    }

    private int brighter(int channel, float amount) {
        int step = (int) Math.min(passed.length - 1, amount * STEPS_PER_UNIT);
        return Math.round(255 - (255 - channel) * passed[step]);
    }
}
