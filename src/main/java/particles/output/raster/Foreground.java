package particles.output.raster;

/**
 * The things of a frame that are drawn already, and hide light and lines that are added behind them.
 *
 * @param raster   the opaque shapes
 * @param backdrop the planes and spheres behind them
 */
public record Foreground(Raster raster, Backdrop backdrop) {

    /** @return whether a point of this nearness is visible at a pixel */
    public boolean shows(double near, int x, int y) {
        return near > backdrop.near(y * backdrop.width + x) && near > raster.nearAt(x, y);
    }
}
