package particles.output.painters;

import java.util.List;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.Colours;
import particles.output.raster.Foreground;
import particles.output.raster.LightLayer;

/**
 * Draws particles as spots of light, whose colour and brightness depend on their age relative to their lifetime.
 *
 * @param colours the colours from birth to death, evenly spread
 * @param layer   the light of a frame
 */
public record GlowPainter(List<Integer> colours, LightLayer layer) {
    private static final double BRIGHTNESS = 0.45;

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

    /** Adds the particles' light to a layer. */
    public void paint(FrameState state, CameraProjection view, VisibilityFilter shown, double radius,
            Foreground foreground, int[] pixels) {
        Place[] places = state.places(view);
        FrameStructure lives = state.structure();
        layer.clear(foreground);
        for (int i = 0; i < state.particles(); i++) {
            if (places[i].visible() && !state.isFixed(i) && shown.particle(i)) {
                double age = age(state.time(), lives.births()[i], lives.deaths()[i]);
                layer.spot(places[i], radius * places[i].scale(), colour(colours, age), BRIGHTNESS * (1 - age));
            }
        }
        layer.addTo(pixels);
    }
}
