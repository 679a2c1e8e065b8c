package particles.output.painters;

import particles.output.raster.CameraProjection;
import particles.output.raster.Raster;

/** Points projected by the camera, such as the particles of a frame, in samples of the raster. */
public final class ProjectedParticles {
    final double[] x;
    final double[] y;
    final double[] near;
    final double[] depth;
    /** Samples per metre there. */
    final double[] scale;
    /** Whether the point can be drawn: in front of the camera and with finite coordinates. */
    final boolean[] visible;

    /**
     * @param view  the camera
     * @param p     the points, three coordinates each (m)
     * @param count their number
     */
    public ProjectedParticles(CameraProjection view, double[] p, int count) {
        x = new double[count];
        y = new double[count];
        near = new double[count];
        depth = new double[count];
        scale = new double[count];
        visible = new boolean[count];
        for (int i = 0, at = 0; i < count; i++, at += 3) {
            CameraProjection.Place place = view.place(p[at], p[at + 1], p[at + 2]);
            depth[i] = place.depth();
            near[i] = view.nearness(depth[i]);
            scale[i] = Raster.SAMPLES * place.scale();
            x[i] = Raster.SAMPLES * place.x();
            y[i] = Raster.SAMPLES * place.y();
            visible[i] = view.isInFront(depth[i]) && Double.isFinite(x[i]) && Double.isFinite(y[i]);
        }
    }
}
