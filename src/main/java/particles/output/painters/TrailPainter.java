package particles.output.painters;

import java.util.Arrays;
import java.util.List;
import particles.law.Vector3;
import particles.output.raster.Backdrop.Foreground;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.Capsule;
import particles.output.raster.Colours;

/** Draws the past paths of particles as fading lines, hidden by anything nearer. */
public final class TrailPainter {
    /** The opacity of a line at the particle. */
    private static final double STRONGEST = 0.85;
    /** Half the line's width, relative to the picture's height. */
    private static final double HALF_WIDTH = 0.0018;

    private final CameraProjection view;
    private final double duration;
    private final double half;
    private final float[] cover;
    private final int[] colours;

    /** Creates a painter for trails of this duration (s), unless a particle has its own. */
    public TrailPainter(CameraProjection view, double duration) {
        this.view = view;
        this.duration = duration;
        half = Math.max(0.7, HALF_WIDTH * view.height);
        cover = new float[view.width * view.height];
        colours = new int[cover.length];
    }

    /** Draws all trails of a frame. */
    public void paint(FrameState state, VisibilityFilter shown, int rgb, Foreground foreground, int[] pixels) {
        Arrays.fill(cover, 0);
        for (int i = 0; i < state.particles(); i++) {
            if (!state.isFixed(i) && shown.particle(i)) {
                follow(state, i, state.structure().trail(i, duration), state.structure().colour(i, rgb), foreground);
            }
        }
        for (int p = 0; p < cover.length; p++) {
            if (cover[p] > 0) {
                pixels[p] = Colours.mix(pixels[p], colours[p], cover[p]);
            }
        }
    }

    /** Draws one path backwards in time from the particle. */
    private void follow(FrameState state, int i, double seconds, int rgb, Foreground foreground) {
        if (seconds == 0) {
            return;
        }
        Place from = view.place(state.place(i));
        double fromShare = 1;
        List<Vector3> path = state.path(i);
        for (int k = 0; k < path.size() && fromShare > 0; k++) {
            Place to = view.place(path.get(k));
            double share = 1 - (state.time() - state.trail().get(k).time()) / seconds;
            line(from, to, STRONGEST * fromShare, STRONGEST * Math.max(0, share), rgb, foreground);
            from = to;
            fromShare = share;
        }
    }

    private void line(Place a, Place b, double opacityA, double opacityB, int rgb, Foreground foreground) {
        double reach = half + 0.5;
        Capsule line = new Capsule(a, b, reach);
        line.draw(view.width, view.height, (x, y, along, dx, dy) -> {
            // sqrt is enough for pixels and ten times faster than hypot
            double off = Math.sqrt(dx * dx + dy * dy);
            float covered = (float) (Math.min(1, reach - off) * (opacityA + along * (opacityB - opacityA)));
            int p = y * view.width + x;
            boolean strongest = covered > cover[p] && foreground.shows(line.near(along), x, y);
            if (strongest) {
                cover[p] = covered;
                colours[p] = rgb;
            }
            return strongest;
        });
    }
}
