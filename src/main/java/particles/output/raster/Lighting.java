package particles.output.raster;

import particles.law.Vector3;
import particles.output.raster.CameraProjection.Direction;

/**
 * The light: one distant lamp, above and a little to the left in front, and ambient light that is stronger from above.
 */
public final class Lighting {
    private static final float AMBIENT = 0.54f;
    private static final float FROM_ABOVE = 0.09f;
    private static final float LAMP = 0.50f;
    private static final float GLOSS = 0.28f;

    /** Towards the lamp, in space. */
    final Vector3 lamp;
    private final Direction seenLamp;
    /** Halfway between the lamp and the viewer. */
    private final Direction half;
    private final Direction up;

    /** @param worldUp the direction that is up for the lamp */
    public Lighting(CameraProjection view, Vector3 worldUp) {
        Vector3 above = worldUp.normalized();
        lamp = above.times(1.0).plus(view.right.times(-0.35)).plus(view.back.times(0.75)).normalized();
        seenLamp = view.turned(lamp);
        half = view.turned(lamp.plus(view.back).normalized());
        up = view.turned(above);
    }

    /** @return the light on a surface with this normal */
    float light(Direction normal) {
        return AMBIENT + FROM_ABOVE * up.dot(normal) + LAMP * Math.max(0, seenLamp.dot(normal));
    }

    /** @return a colour in this light, on a surface with this normal, with a highlight of this strength */
    public int shade(int rgb, Direction normal, float gloss) {
        return Colours.lit(rgb, light(normal), gloss * highlight(normal));
    }

    /** @return the highlight there, from 0 to 1 */
    private float highlight(Direction normal) {
        float h = half.dot(normal);
        if (h <= 0) {
            return 0;
        }
        for (int doubling = 0; doubling < 5; doubling++) {
            h *= h;                                 // to the power of 32 in the end
        }
        return GLOSS * h;
    }
}
