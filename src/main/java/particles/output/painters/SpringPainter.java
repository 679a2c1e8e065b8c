package particles.output.painters;

import particles.output.raster.CameraProjection;
import particles.output.raster.Colours;
import particles.output.raster.RoundShapes;
import particles.view.RenderOptions;

/**
 * Draws springs, coloured by their strain: as coils if they are few or soft, as straight tubes if they are many. Rods,
 * and springs between fixed particles, are drawn as bars.
 */
public final class SpringPainter {
    private static final int ROD = 0x6c7683;
    private static final int SEGMENTS_A_TURN = 18;
    /**
     * The straight piece at either end of a coil, and the point at which it has its full width, as fractions of the
     * length.
     */
    private static final double STRAIGHT = 0.07;
    private static final double WIDE = 0.11;
    /** The lift of springs, as a fraction of the picture's height. */
    private static final double LIFT = 0.004;

    private final RoundShapes shapes;
    private final CameraProjection view;
    private final RenderOptions look;
    private final DrawnSizes sizes;
    private final ProjectedParticles coil;

    /** Creates a painter that draws springs in these sizes. */
    public SpringPainter(RoundShapes shapes, CameraProjection view, RenderOptions look, DrawnSizes sizes) {
        this.shapes = shapes;
        this.view = view;
        this.look = look;
        this.sizes = sizes;
        this.coil = new ProjectedParticles(view);
    }

    /** @return whether any spring with strain is visible so far */
    public boolean paint(FrameState state, ProjectedParticles projected, VisibilityFilter shown) {
        boolean seen = false;
        for (int s = 0; s < state.springs; s++) {
            if (shown.spring(state.from[s], state.to[s])) {
                seen |= paint(state, projected, s);
            }
        }
        return seen;
    }

    private boolean paint(FrameState state, ProjectedParticles projected, int s) {
        int a = state.from[s];
        int b = state.to[s];
        if (!projected.visible[a] || !projected.visible[b]) {
            return false;
        }
        if (state.rigid[s] || state.fixed[a] && state.fixed[b]) {
            double radius = sizes.rod() * (projected.scale[a] + projected.scale[b]) / 2;
            shapes.tube(projected.x[a], projected.y[a], projected.near[a], projected.x[b], projected.y[b],
                    projected.near[b],
                    radius, ROD);
            return false;
        }
        double[] p = state.positions;
        double dx = p[3 * b] - p[3 * a];
        double dy = p[3 * b + 1] - p[3 * a + 1];
        double dz = p[3 * b + 2] - p[3 * a + 2];
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double rest = state.restLength[s];
        double strain = rest > 0 ? (length - rest) / rest : length > 0 ? look.strainRange() : 0;
        int rgb = Colours.ofStrain(strain, look.strainRange());
        if (sizes.isCoil(state, s) && length > 4 * sizes.wire() && rest > 0) {
            return paintCoil(p, 3 * a, new double[] {dx / length, dy / length, dz / length}, length, rest, rgb);
        }
        double radius = sizes.tube() * (projected.scale[a] + projected.scale[b]) / 2;
        return shapes.tube(projected.x[a], projected.y[a], lifted(projected, a), projected.x[b], projected.y[b],
                lifted(projected, b), radius, rgb);
    }

    /** The nearness of an end, a little increased, so that a surface spanned by springs does not hide half of each. */
    private double lifted(ProjectedParticles projected, int i) {
        return view.nearness(projected.depth[i] - LIFT * view.viewHeight);
    }

    /** Draws a helix from particle to particle; the number of turns does not change with length. */
    private boolean paintCoil(double[] p, int at, double[] direction, double length, double rest, int rgb) {
        double ex = direction[0];
        double ey = direction[1];
        double ez = direction[2];
        // two directions across, the first of them as far as possible towards the viewer
        double along = ex * view.back.x() + ey * view.back.y() + ez * view.back.z();
        boolean endOn = Math.abs(along) > 0.999;
        double rx = endOn ? view.right.x() : view.back.x();
        double ry = endOn ? view.right.y() : view.back.y();
        double rz = endOn ? view.right.z() : view.back.z();
        double part = ex * rx + ey * ry + ez * rz;
        double qx = rx - part * ex;
        double qy = ry - part * ey;
        double qz = rz - part * ez;
        double size = Math.sqrt(qx * qx + qy * qy + qz * qz);
        qx /= size;
        qy /= size;
        qz /= size;
        double px = ey * qz - ez * qy;
        double py = ez * qx - ex * qz;
        double pz = ex * qy - ey * qx;
        int turns = (int) Math.max(4, Math.min(16, Math.rint(rest / (1.5 * sizes.coil()))));
        int segments = turns * SEGMENTS_A_TURN;
        coil.reserve(segments + 1);
        for (int k = 0; k <= segments; k++) {
            double t = (double) k / segments;
            double inside = Math.min(t, 1 - t);
            double radius = sizes.coil() * Math.max(0, Math.min(1, (inside - STRAIGHT) / (WIDE - STRAIGHT)));
            double angle = 2 * Math.PI * turns * (t - STRAIGHT) / (1 - 2 * STRAIGHT);
            double u = radius * Math.sin(angle);
            double v = radius * Math.cos(angle);
            coil.put(k, p[at] + t * length * ex + u * px + v * qx, p[at + 1] + t * length * ey + u * py + v * qy,
                    p[at + 2] + t * length * ez + u * pz + v * qz);
        }
        boolean seen = false;
        for (int k = 0; k < segments; k++) {
            if (coil.visible[k] && coil.visible[k + 1]) {
                seen |= shapes.tube(coil.x[k], coil.y[k], coil.near[k], coil.x[k + 1], coil.y[k + 1], coil.near[k + 1],
                        sizes.wire() * coil.scale[k], rgb);
            }
        }
        return seen;
    }
}
