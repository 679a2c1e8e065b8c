package particles.output.raster;

import particles.law.Vector3;
import particles.view.Camera;

/**
 * Projects points of space to pixels of a picture, or to samples of a raster, and back to rays. Nearness decides
 * visibility: 1 / distance in a perspective view, -distance in an orthographic one, so that on a plane it is an affine
 * function of the picture coordinates.
 */
public final class CameraProjection {
    /** Near clipping distance of a perspective view, as a fraction of the distance to the target. */
    private static final double NEAREST = 0.02;

    /** The width of the picture (pixels). */
    public final int width;
    /** The height of the picture (pixels). */
    public final int height;
    final boolean perspective;
    final Vector3 eye;
    /** The direction to the right in the picture, a unit vector. */
    public final Vector3 right;
    /** The direction upwards in the picture, a unit vector. */
    public final Vector3 up;
    /** The direction towards the viewer, a unit vector. */
    public final Vector3 back;
    /** The height of the picture in the plane through the target (m). */
    public final double viewHeight;
    private final double focal;
    private final double nearest;

    /** @throws IllegalArgumentException if the camera has no direction */
    public CameraProjection(Camera camera, int width, int height) {
        this.width = width;
        this.height = height;
        perspective = camera.perspective();
        eye = camera.position();
        Vector3 sight = eye.minus(camera.target());
        back = sight.normalized();
        right = camera.up().cross(back).normalized();
        up = back.cross(right);
        double distance = sight.length();
        viewHeight = perspective ? 2 * Math.tan(Math.toRadians(camera.fieldOfView()) / 2) * distance : camera.height();
        focal = perspective ? height * distance / viewHeight : height / viewHeight;
        nearest = NEAREST * distance;
    }

    /** Whether a point at this depth can be drawn. */
    boolean isInFront(double depth) {
        return !perspective || depth > nearest;
    }

    /** @return pixels per metre at this depth */
    double scale(double depth) {
        return perspective ? focal / depth : focal;
    }

    /** @return the nearness of a point at this depth */
    public double nearness(double depth) {
        return perspective ? 1 / depth : -depth;
    }

    /**
     * A point as the camera sees it.
     *
     * @param x       its distance from the left edge (pixels); may be far outside, or not finite
     * @param y       its distance from the top edge
     * @param depth   its depth (m)
     * @param scale   pixels per metre there
     * @param near    its nearness
     * @param visible whether it is in front of the camera
     */
    public record Place(double x, double y, double depth, double scale, double near, boolean visible) {
    }

    /** @return where the camera sees a point, in front of it or not */
    public Place place(Vector3 point) {
        Vector3 from = point.minus(eye);
        double depth = -from.dot(back);
        double scale = scale(depth);
        return new Place(width / 2.0 + scale * from.dot(right), height / 2.0 - scale * from.dot(up), depth, scale,
                nearness(depth), isInFront(depth));
    }

    /** @return a direction in space as the camera sees it */
    public Direction turned(Vector3 direction) {
        return new Direction((float) direction.dot(right), (float) direction.dot(up), (float) direction.dot(back));
    }

    /** @return whether the point is inside the picture */
    public boolean isInPicture(Vector3 point) {
        Place place = place(point);
        return place.visible && place.x >= 0 && place.x <= width && place.y >= 0 && place.y <= height;
    }

    /**
     * The points that are seen at one point of the picture.
     *
     * @param start     its origin
     * @param direction scaled so that its parameter is the depth
     */
    record Ray(Vector3 start, Vector3 direction) {
        Vector3 at(double depth) {
            return start.plus(direction.times(depth));
        }
    }

    /** @return the ray through a point of the picture */
    Ray ray(double px, double py) {
        Vector3 across = right.times((px - width / 2.0) / focal);
        Vector3 upwards = up.times((height / 2.0 - py) / focal);
        return perspective ? new Ray(eye, across.plus(upwards).minus(back))
                : new Ray(eye.plus(across).plus(upwards), back.times(-1));
    }

    /**
     * A direction as the camera sees it.
     *
     * @param right the component to the right in the picture
     * @param up    the component upwards in the picture
     * @param back  the component towards the viewer
     */
    public record Direction(float right, float up, float back) {
        /** @return the scalar product with another direction */
        float dot(Direction other) {
            return other.right * right + other.up * up + other.back * back;
        }
    }
}
