package particles.view;

import particles.law.Vector3;

/**
 * The camera: position, direction and projection.
 *
 * @param position    the camera's position (m)
 * @param target      the point it looks at, in the middle of the picture (m)
 * @param up          the direction that is up in the picture
 * @param perspective true for a perspective view, false for an orthographic one
 * @param fieldOfView the full vertical angle of a perspective view (degrees)
 * @param height      the height of an orthographic view (m)
 */
public record Camera(Vector3 position, Vector3 target, Vector3 up, boolean perspective, double fieldOfView,
        double height) {
    private static final double FIELD_OF_VIEW = 35;
    /** The fraction of the picture for the scene; the corners are for text. */
    private static final double FILLED = 0.74;
    /** A scene thinner along an axis than this fraction of its largest extent is flat and seen from the front. */
    private static final double FLAT = 0.05;
    private static final Vector3 UP = new Vector3(0, 1, 0);
    private static final Vector3 FROM_THE_SIDE = new Vector3(0.55, 0.42, 1);
    private static final Vector3 FROM_THE_FRONT = new Vector3(0.22, 0.16, 1);

    /**
     * Frames a box: a little from above and from the right, as near as possible with everything in the picture.
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
        Vector3 right = UP.cross(from).normalized();
        Vector3 up = from.cross(right);
        double filled = FILLED * Math.tan(Math.toRadians(FIELD_OF_VIEW) / 2);
        double distance = 0;
        for (int corner = 0; corner < 8; corner++) {
            Vector3 at = new Vector3(size.x() * ((corner & 1) - 0.5), size.y() * ((corner >> 1 & 1) - 0.5),
                    size.z() * ((corner >> 2) - 0.5));
            double beside = Math.max(Math.abs(at.dot(right)) / aspect, Math.abs(at.dot(up)));
            distance = Math.max(distance, at.dot(from) + beside / filled);
        }
        return new Camera(middle.plus(from.times(distance)), middle, UP, true, FIELD_OF_VIEW, 0);
    }
}
