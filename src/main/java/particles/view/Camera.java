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
}
