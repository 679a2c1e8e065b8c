package particles.output.raster;

import particles.law.Vector3;
import particles.view.Camera;

/**
 * Places a default camera: a little from above and from the right, as near as possible with everything in the picture.
 */
public final class CameraFraming {
    private static final double FIELD_OF_VIEW = 35;
    /** The fraction of the picture for the scene; the corners are for text. */
    private static final double FILLED = 0.74;
    /** A scene thinner along an axis than this fraction of its largest extent is flat and seen from the front. */
    private static final double FLAT = 0.05;
    private static final Vector3 UP = new Vector3(0, 1, 0);
    private static final Vector3 FROM_THE_SIDE = new Vector3(0.55, 0.42, 1);
    private static final Vector3 FROM_THE_FRONT = new Vector3(0.22, 0.16, 1);

    private CameraFraming() {
    }

    /**
     * Frames a box.
     *
     * @param low    its lower corner (m)
     * @param high   its upper corner (m)
     * @param aspect the width of the pictures divided by their height
     * @return a perspective camera
     */
    public static Camera around(Vector3 low, Vector3 high, double aspect) {
        Vector3 size = high.minus(low);
        Vector3 middle = low.plus(size.times(0.5));
        double largest = Math.max(size.x(), Math.max(size.y(), size.z()));
        if (!(largest > 0) || !(largest <= 1e100)) {
            largest = 1;
            size = new Vector3(1, 1, 1);
        }
        Vector3 from = (size.z() <= FLAT * largest ? FROM_THE_FRONT : FROM_THE_SIDE).normalized();
        double near = 0.1 * largest;
        double far = 100 * largest / Math.min(1, aspect);
        for (int halving = 0; halving < 60; halving++) {
            double middleWay = (near + far) / 2;
            if (fits(camera(middle, from, middleWay), middle, size, aspect)) {
                far = middleWay;
            } else {
                near = middleWay;
            }
        }
        return camera(middle, from, far);
    }

    private static Camera camera(Vector3 target, Vector3 from, double distance) {
        return new Camera(target.plus(from.times(distance)), target, UP, true, FIELD_OF_VIEW, 0);
    }

    private static boolean fits(Camera camera, Vector3 middle, Vector3 size, double aspect) {
        int height = 1000;
        CameraProjection view = new CameraProjection(camera, (int) Math.ceil(aspect * height), height);
        for (int corner = 0; corner < 8; corner++) {
            double x = middle.x() + size.x() * ((corner & 1) - 0.5);
            double y = middle.y() + size.y() * ((corner >> 1 & 1) - 0.5);
            double z = middle.z() + size.z() * ((corner >> 2 & 1) - 0.5);
            if (!view.isInPicture(x, y, z, FILLED)) {
                return false;
            }
        }
        return true;
    }
}
