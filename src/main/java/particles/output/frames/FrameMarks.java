package particles.output.frames;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.output.files.FontCheck;
import particles.output.frames.FrameText.TextLine;
import particles.output.painters.FrameState;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.Sky;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;

/** Arrows along velocities and the labels of particles, drawn over the picture so that nothing hides them. */
final class FrameMarks {
    private static final Color ARROW = new Color(0x009e73);
    /** Nothing is drawn farther out than this (pixels). */
    private static final double FARTHEST = 1e5;

    private final CameraProjection view;
    private final ParticleStyle style;
    private final Sky sky;
    private final float unit;
    private final Font font;

    FrameMarks(CameraProjection view, RenderOptions look) {
        this.view = view;
        style = look.style();
        sky = Sky.of(look);
        unit = Math.max(0.5f, view.height / 720f);
        font = FontCheck.font(Font.PLAIN, 18 * unit);
    }

    /** @param ball the radius of a ball (m) */
    void draw(Graphics2D g, FrameState state, double ball) {
        TextLine.smooth(g);
        g.setColor(ARROW);
        for (int i = 0; i < state.particles() && style.arrows() > 0; i++) {
            if (!state.isFixed(i)) {
                join(state.place(i), state.place(i).plus(state.velocity(i).times(style.arrows())),
                        line -> drawArrow(g, line));
            }
        }
        for (TextLine label : FontCheck.isAvailable() ? labels(state, ball) : List.<TextLine>of()) {
            for (int k = 0; k < 8; k++) {
                double angle = Math.PI / 4 * k;
                new TextLine(label.text(), font, sky.text().halo(), label.x() + 1.6 * unit * Math.cos(angle),
                        label.y() + 1.6 * unit * Math.sin(angle)).draw(g);
            }
            label.draw(g);
        }
    }

    /** @return the rectangles that labels take up (pixels) */
    List<Rectangle2D> boxes(FrameState state, double ball) {
        return labels(state, ball).stream().map(TextLine::box).toList();
    }

    private List<TextLine> labels(FrameState state, double ball) {
        Map<Integer, Rectangle2D> balls = new LinkedHashMap<>();
        for (int k = 0; k < state.particles(); k++) {
            int i = k;
            if (!state.structure().label(i).isEmpty()) {
                place(state.place(i)).ifPresent(at -> {
                    double radius = state.structure().radius(i, ball) * at.scale();
                    balls.put(i, new Rectangle2D.Double(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius));
                });
            }
        }
        List<TextLine> labels = new ArrayList<>();
        balls.forEach((i, own) -> {
            List<Rectangle2D> taken = new ArrayList<>(balls.values());
            taken.remove(own);
            labels.forEach(label -> taken.add(label.box()));
            labels.add(label(state.structure().label(i), own, taken, lines(state, i)));
        });
        return labels;
    }

    /** The springs, rods and trail of a particle. */
    private List<Line2D> lines(FrameState state, int particle) {
        List<Line2D> lines = new ArrayList<>();
        for (int s = 0; s < state.springs().count(); s++) {
            int from = state.springs().from()[s];
            int to = state.springs().to()[s];
            if (from == particle || to == particle) {
                join(state.place(from), state.place(to), lines::add);
            }
        }
        List<Vector3> path = state.isFixed(particle) ? List.of() : state.path(particle);
        for (int k = 1; k < path.size(); k++) {
            join(path.get(k - 1), path.get(k), lines::add);
        }
        return lines;
    }

    private void join(Vector3 from, Vector3 to, Consumer<Line2D> use) {
        place(from).ifPresent(a -> place(to).ifPresent(b -> use.accept(new Line2D.Double(a.x(), a.y(), b.x(), b.y()))));
    }

    /**
     * Places a label to the right of the ball, or else to its left, above or below: inside the picture and on free
     * ground, if possible also beside the ball's own springs and trail.
     */
    private TextLine label(String text, Rectangle2D ball, List<Rectangle2D> taken, List<Line2D> lines) {
        double width = TextLine.width(text, font);
        double right = ball.getMaxX() + 6 * unit;
        double middle = ball.getCenterX() - width / 2;
        double level = ball.getCenterY() + 6 * unit;
        List<TextLine> places = Stream.of(new Point2D.Double(right, level),
                new Point2D.Double(ball.getX() - 6 * unit - width, level),
                new Point2D.Double(middle, ball.getY() - 14 * unit),
                new Point2D.Double(middle, ball.getMaxY() + 26 * unit))
                .map(at -> new TextLine(text, font, sky.text().ink(), at.x, at.y)).toList();
        List<TextLine> free = places.stream().filter(place -> place.x() >= 0 && place.x() + width < view.width
                && taken.stream().noneMatch(place.box()::intersects)).toList();
        return free.stream().filter(place -> lines.stream().noneMatch(place.box()::intersectsLine)).findFirst()
                .or(() -> free.stream().findFirst()).orElse(places.get(right + width < view.width ? 0 : 1));
    }

    private void drawArrow(Graphics2D g, Line2D line) {
        double length = line.getP1().distance(line.getP2());
        if (!(length > unit) || !(length < FARTHEST)) {
            return;
        }
        double head = Math.min(length, 15 * unit);
        // drawn along the x axis with its tip at 0, and turned
        AffineTransform turned = AffineTransform.getTranslateInstance(line.getX2(), line.getY2());
        turned.rotate(line.getX2() - line.getX1(), line.getY2() - line.getY1());
        g.setStroke(new BasicStroke(3 * unit, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND));
        g.draw(turned.createTransformedShape(new Line2D.Double(-length, 0, -0.9 * head, 0)));
        Path2D tip = new Path2D.Double();
        tip.moveTo(0, 0);
        tip.lineTo(-head, -0.45 * head);
        tip.lineTo(-head, 0.45 * head);
        tip.closePath();
        g.fill(turned.createTransformedShape(tip));
    }

    /** @return where it is seen, if it can be drawn */
    private Optional<Place> place(Vector3 point) {
        Place place = view.place(point);
        boolean near = Math.abs(place.x()) < FARTHEST && Math.abs(place.y()) < FARTHEST;      // false for NaN
        return place.visible() && near ? Optional.of(place) : Optional.empty();
    }
}
