package particles.output.raster;

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
