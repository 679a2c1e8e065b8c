package particles.output.painters;

import java.util.Arrays;
import java.util.List;
import particles.output.painters.FrameState.FrameStructure;
import particles.output.raster.Backdrop.Foreground;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.Capsule;
import particles.output.raster.Colours;

/**
 * Draws particles as spots of light, whose colour and brightness depend on their age relative to their lifetime. Added
 * light saturates towards white: c becomes 255 - (255 - c) exp(-light).
 */
public final class GlowPainter {
    private static final double BRIGHTNESS = 0.45;
    private static final int STEPS_PER_UNIT = 256;
    private static final double MOST = 8;
    /** Where the channels of a colour are: red, green, blue. */
    private static final int[] SHIFTS = {16, 8, 0};

    private final List<Integer> colours;
    private final CameraProjection view;
    /** Red, green, blue a pixel. */
    private final float[] light;
    private final float[] passed = new float[(int) (MOST * STEPS_PER_UNIT) + 1];

    /**
     * @param colours the colours from birth to death, evenly spread
     * @param view    the camera, with the size of the pictures
     */
    public GlowPainter(List<Integer> colours, CameraProjection view) {
        this.colours = colours;
        this.view = view;
        light = new float[3 * view.width * view.height];
        for (int k = 0; k < passed.length; k++) {
            passed[k] = (float) Math.exp(-(double) k / STEPS_PER_UNIT);
        }
    }

    /** @return the age relative to the lifetime; 0 for particles without one */
    static double age(double time, double birth, double death) {
        double age = (time - birth) / (death - birth);
        return age >= 0 ? Math.min(1, age) : 0;             // 0 for NaN
    }

    static int colour(List<Integer> colours, double age) {
        double at = age * (colours.size() - 1);
        int k = Math.min(colours.size() - 1, (int) at);
        return Colours.mix(colours.get(k), colours.get(Math.min(colours.size() - 1, k + 1)), at - k);
    }

    /** Brightens a picture by the particles' light, where nothing in the foreground hides them. */
    public void paint(FrameState state, VisibilityFilter shown, double radius, Foreground foreground, int[] pixels) {
        Place[] places = state.places(view);
        FrameStructure lives = state.structure();
        Arrays.fill(light, 0);
        for (int i = 0; i < state.particles(); i++) {
            if (places[i].visible() && !state.isFixed(i) && shown.particle(i)) {
                double age = age(state.time(), lives.births()[i], lives.deaths()[i]);
                add(places[i], radius * places[i].scale(), colour(colours, age), BRIGHTNESS * (1 - age), foreground);
            }
        }
        for (int k = 0; k < light.length; k++) {
            if (light[k] > 0) {
                int shift = SHIFTS[k % 3];
                int channel = pixels[k / 3] >> shift & 255;
                int step = (int) Math.min(passed.length - 1, light[k] * STEPS_PER_UNIT);
                pixels[k / 3] += Math.round(255 - (255 - channel) * passed[step]) - channel << shift;
            }
        }
    }

    /**
     * Adds a round spot with brightness (1 - d&sup2;/r&sup2;)&sup2;.
     *
     * @param at         the place of the middle
     * @param radius     r, in pixels
     * @param rgb        its colour
     * @param brightness the brightness of its centre; 1 turns black into most of the colour
     */
    private void add(Place at, double radius, int rgb, double brightness, Foreground foreground) {
        float[] colour = new float[3];
        for (int c = 0; c < 3; c++) {
            colour[c] = (float) (brightness * (rgb >> SHIFTS[c] & 255) / 255);
        }
        new Capsule(at, at, radius).draw(view.width, view.height, (x, y, along, dx, dy) -> {
            double rest = 1 - dx / radius * (dx / radius) - dy / radius * (dy / radius);
            boolean seen = foreground.shows(at.near(), x, y);
            for (int c = 0; seen && c < 3; c++) {
                light[3 * (y * view.width + x) + c] += (float) (rest * rest) * colour[c];
            }
            return seen;
        });
    }
}
