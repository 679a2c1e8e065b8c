package particles.output.raster;

import particles.law.Vector3;

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
    // lamp, half vector and up in the camera's coordinates (right, up, back)
    private final float lampX;
    private final float lampY;
    private final float lampZ;
    private final float halfX;
    private final float halfY;
    private final float halfZ;
    private final float upX;
    private final float upY;
    private final float upZ;

    /** @param worldUp the direction that is up for the lamp */
    public Lighting(CameraProjection view, Vector3 worldUp) {
        Vector3 up = worldUp.normalized();
        lamp = up.times(1.0).plus(view.right.times(-0.35)).plus(view.back.times(0.75)).normalized();
        Vector3 half = lamp.plus(view.back).normalized();
        lampX = (float) lamp.dot(view.right);
        lampY = (float) lamp.dot(view.up);
        lampZ = (float) lamp.dot(view.back);
        halfX = (float) half.dot(view.right);
        halfY = (float) half.dot(view.up);
        halfZ = (float) half.dot(view.back);
        upX = (float) up.dot(view.right);
        upY = (float) up.dot(view.up);
        upZ = (float) up.dot(view.back);
    }

    /** @return the light on a surface with this normal, along the camera's right, up and back */
    public float light(float nx, float ny, float nz) {
        float lambert = Math.max(0, nx * lampX + ny * lampY + nz * lampZ);
        return AMBIENT + FROM_ABOVE * (nx * upX + ny * upY + nz * upZ) + LAMP * lambert;
    }

    /** @return the highlight there, from 0 to 1 */
    public float highlight(float nx, float ny, float nz) {
        float h = nx * halfX + ny * halfY + nz * halfZ;
        if (h <= 0) {
            return 0;
        }
        float h2 = h * h;
        float h4 = h2 * h2;
        float h8 = h4 * h4;
        float h16 = h8 * h8;
        return GLOSS * h16 * h16;
    }
}
