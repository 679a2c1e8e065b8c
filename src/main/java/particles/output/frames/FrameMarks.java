package particles.output.frames;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.output.painters.FrameState;
import particles.output.raster.CameraProjection;
import particles.output.raster.Sky;
import particles.output.text.FontCheck;
import particles.view.ParticleStyle;

/** Arrows along velocities and the labels of particles, drawn over the picture so that nothing hides them. */
final class FrameMarks {
    private static final Color ARROW = new Color(0x009e73);
    /** Nothing is drawn farther out than this (pixels). */
    private static final double FARTHEST = 1e5;
    private static final FontRenderContext SMOOTH = new FontRenderContext(null, true, true);

    private final CameraProjection view;
    private final ParticleStyle style;
    private final Sky sky;
    private final float unit;

    /** A particle's label: its left end, and its baseline from the top (pixels). */
    private record Label(String text, double x, double y) {
    }

    FrameMarks(CameraProjection view, ParticleStyle style) {
        this.view = view;
        this.style = style;
        sky = Sky.of(style.night());
        unit = Math.max(0.5f, view.height / 720f);
    }

    /** @param ball the radius of a ball (m) */
    void draw(Graphics2D g, FrameState state, double ball) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        if (style.arrows() > 0) {
            drawArrows(g, state);
        }
        if (FontCheck.isAvailable()) {
            g.setFont(font());
            for (Label label : labels(state, ball)) {
                g.setColor(sky.text.halo());
                for (int k = 0; k < 8; k++) {
                    double angle = Math.PI / 4 * k;
                    g.drawString(label.text, (float) (label.x + 1.6 * unit * Math.cos(angle)),
                            (float) (label.y + 1.6 * unit * Math.sin(angle)));
                }
                g.setColor(sky.text.ink());
                g.drawString(label.text, (float) label.x, (float) label.y);
            }
        }
    }

    /** @return the rectangles that labels take up (pixels) */
    List<Rectangle2D> boxes(FrameState state, double ball) {
        return labels(state, ball).stream().map(this::box).toList();
    }

    private Rectangle2D box(Label label) {
        Rectangle2D box = font().getStringBounds(label.text, SMOOTH);
        return new Rectangle2D.Double(label.x, label.y + box.getY(), box.getWidth(), box.getHeight());
    }

    private Font font() {
        return FontCheck.font(Font.PLAIN, 18 * unit);
    }

    private List<Label> labels(FrameState state, double ball) {
        List<Rectangle2D> balls = new ArrayList<>();
        List<Integer> labelled = new ArrayList<>();
        for (int i = 0; i < state.particles; i++) {
            Optional<double[]> seen = state.label(i).isEmpty() ? Optional.empty() : place(state, i, 0);
            if (seen.isPresent()) {
                double[] at = seen.get();
                double radius = state.radius(i, ball) * at[2];
                labelled.add(i);
                balls.add(new Rectangle2D.Double(at[0] - radius, at[1] - radius, 2 * radius, 2 * radius));
            }
        }
        List<Label> labels = new ArrayList<>();
        for (int k = 0; k < balls.size(); k++) {
            List<Rectangle2D> taken = new ArrayList<>(balls);
            taken.remove(k);
            labels.forEach(label -> taken.add(box(label)));
            List<Line2D> lines = springs(state, labelled.get(k));
            lines.addAll(trail(state, labelled.get(k)));
            labels.add(label(state.label(labelled.get(k)), balls.get(k), taken, lines));
        }
        return labels;
    }

    /** The springs and rods of a particle. */
    private List<Line2D> springs(FrameState state, int particle) {
        List<Line2D> lines = new ArrayList<>();
        for (int s = 0; s < state.springs; s++) {
            Optional<double[]> from = state.from[s] == particle || state.to[s] == particle
                    ? place(state, state.from[s], 0) : Optional.empty();
            Optional<double[]> to = from.isEmpty() ? from : place(state, state.to[s], 0);
            to.ifPresent(end -> lines.add(new Line2D.Double(from.get()[0], from.get()[1], end[0], end[1])));
        }
        return lines;
    }

    /** The trail of a particle, from its newest sample back in time. */
    private List<Line2D> trail(FrameState state, int particle) {
        List<Line2D> lines = new ArrayList<>();
        int index = state.trailIndex.length == 0 ? particle : state.trailIndex[particle];
        Optional<double[]> newer = Optional.empty();
        for (int k = state.trail.length - 1; k >= 0 && index >= 0 && !state.fixed[particle]; k--) {
            float[] places = state.trail[k].places();
            Optional<double[]> older = place(places[3 * index], places[3 * index + 1], places[3 * index + 2]);
            if (newer.isPresent() && older.isPresent()) {
                lines.add(new Line2D.Double(newer.get()[0], newer.get()[1], older.get()[0], older.get()[1]));
            }
            newer = older;
            index = state.trail[k].earlier(index);
        }
        return lines;
    }

    /**
     * Places a label to the right of the ball, or else to its left, above or below: inside the picture and on free
     * ground, if possible also beside the ball's own springs and trail.
     */
    private Label label(String text, Rectangle2D ball, List<Rectangle2D> taken, List<Line2D> lines) {
        double width = font().getStringBounds(text, SMOOTH).getWidth();
        double right = ball.getMaxX() + 6 * unit;
        double left = ball.getX() - 6 * unit - width;
        double middle = ball.getCenterX() - width / 2;
        double level = ball.getCenterY() + 6 * unit;
        List<Label> places = List.of(new Label(text, right, level), new Label(text, left, level),
                new Label(text, middle, ball.getY() - 14 * unit), new Label(text, middle, ball.getMaxY() + 26 * unit));
        List<Label> free = places.stream().filter(place -> place.x >= 0 && place.x + width < view.width)
                .filter(place -> taken.stream().noneMatch(box(place)::intersects)).toList();
        return free.stream().filter(place -> lines.stream().noneMatch(box(place)::intersectsLine)).findFirst()
                .or(() -> free.stream().findFirst()).orElse(places.get(right + width < view.width ? 0 : 1));
    }

    private void drawArrows(Graphics2D g, FrameState state) {
        g.setColor(ARROW);
        for (int i = 0; i < state.particles; i++) {
            Optional<double[]> from = place(state, i, 0);
            Optional<double[]> to = place(state, i, style.arrows());
            if (!state.fixed[i] && from.isPresent() && to.isPresent()) {
                double[] start = from.get();
                drawArrow(g, start[0], start[1], to.get()[0] - start[0], to.get()[1] - start[1]);
            }
        }
    }

    private void drawArrow(Graphics2D g, double x, double y, double dx, double dy) {
        double length = Math.sqrt(dx * dx + dy * dy);
        if (!(length > unit) || !(length < FARTHEST)) {
            return;
        }
        double head = Math.min(length, 15 * unit);
        double ex = dx / length;
        double ey = dy / length;
        g.setStroke(new BasicStroke(3 * unit, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND));
        g.draw(new Line2D.Double(x, y, x + dx - 0.9 * head * ex, y + dy - 0.9 * head * ey));
        Path2D tip = new Path2D.Double();
        tip.moveTo(x + dx, y + dy);
        tip.lineTo(x + dx - head * ex - 0.45 * head * ey, y + dy - head * ey + 0.45 * head * ex);
        tip.lineTo(x + dx - head * ex + 0.45 * head * ey, y + dy - head * ey - 0.45 * head * ex);
        tip.closePath();
        g.fill(tip);
    }

    /** @return pixels from the left and from the top, and pixels per metre, if it can be drawn */
    private Optional<double[]> place(FrameState state, int i, double seconds) {
        double[] at = new double[3];
        for (int c = 0; c < 3; c++) {
            at[c] = state.positions[3 * i + c] + (seconds > 0 ? seconds * state.velocities[3 * i + c] : 0);
        }
        return place(at[0], at[1], at[2]);
    }

    private Optional<double[]> place(double x, double y, double z) {
        double depth = view.depth(x, y, z);
        double scale = view.scale(depth);
        double[] place = {view.x(x, y, z, scale), view.y(x, y, z, scale), scale};
        boolean near = Math.abs(place[0]) < FARTHEST && Math.abs(place[1]) < FARTHEST;      // false for NaN
        return view.isInFront(depth) && near ? Optional.of(place) : Optional.empty();
    }
}
