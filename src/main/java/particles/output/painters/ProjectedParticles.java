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
            double d = view.depth(p[at], p[at + 1], p[at + 2]);
            double pixels = view.scale(d);
            depth[i] = d;
            near[i] = view.nearness(d);
            scale[i] = Raster.SAMPLES * pixels;
            x[i] = Raster.SAMPLES * view.x(p[at], p[at + 1], p[at + 2], pixels);
            y[i] = Raster.SAMPLES * view.y(p[at], p[at + 1], p[at + 2], pixels);
            visible[i] = view.isInFront(d) && Double.isFinite(x[i]) && Double.isFinite(y[i]);
        }
    }
}
