package particles.output.painters;

import particles.output.raster.CameraProjection;
import particles.output.raster.Raster;

/** The particles of a frame projected by the camera, in samples of the raster. */
public final class ProjectedParticles {
    double[] x = {};
    double[] y = {};
    double[] near = {};
    double[] depth = {};
    /** Samples per metre there. */
    double[] scale = {};
    /** Whether the particle can be drawn: in front of the camera and with finite coordinates. */
    boolean[] visible = {};
    private final CameraProjection view;

    /** Creates room for the particles that this camera projects. */
    public ProjectedParticles(CameraProjection view) {
        this.view = view;
    }

    /** Projects the particles of a frame. */
    public void take(FrameState state) {
        int n = state.particles;
        reserve(n);
        double[] p = state.positions;
        for (int i = 0; i < n; i++) {
            put(i, p[3 * i], p[3 * i + 1], p[3 * i + 2]);
        }
    }

    /** Makes room for n points. */
    void reserve(int n) {
        if (x.length < n) {
            x = new double[n];
            y = new double[n];
            near = new double[n];
            depth = new double[n];
            scale = new double[n];
            visible = new boolean[n];
        }
    }

    void put(int i, double px, double py, double pz) {
        double d = view.depth(px, py, pz);
        double pixels = view.scale(d);
        depth[i] = d;
        near[i] = view.nearness(d);
        scale[i] = Raster.SAMPLES * pixels;
        x[i] = Raster.SAMPLES * view.x(px, py, pz, pixels);
        y[i] = Raster.SAMPLES * view.y(px, py, pz, pixels);
        visible[i] = view.isInFront(d) && Double.isFinite(x[i]) && Double.isFinite(y[i]);
    }
}
