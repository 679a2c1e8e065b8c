package particles.output.charts;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.output.charts.PageRecorder.Text;
import particles.view.Chart;
import particles.view.Panel;

/** What is wrong with the layout of a page: a line for each fault. */
public final class Layout {
    /** The least type of a slide, as a part of its height. */
    private static final double TYPE = 1.0 / 45;
    private static final int LABELS = 3;
    /** Boxes may share this much (pixels of the layout). */
    private static final double TOUCH = 1;
    /** Measured: panels of stability regions differ by 0.7 % in width. */
    private static final double EQUAL = 0.01;
    /** The labels of an axis are this near to its panel. */
    private static final double NEAR = 14;
    /** Half the size of the point at the end of a curve. */
    private static final double END = 4;

    private final ChartPage page;
    private final List<Text> texts;
    private final List<Rectangle2D> panels;
    private final PageRecorder recorder;
    private final List<String> faults = new ArrayList<>();

    private Layout(ChartPage page) {
        this.page = page;
        recorder = new PageRecorder(page);
        texts = recorder.texts();
        panels = recorder.panels();
    }

    /**
     * @param page   a page
     * @param panels what is drawn on it
     * @param format its format
     * @return the faults of its layout; none if it is right
     */
    public static List<String> faults(ChartPage page, List<Panel> panels, ChartFormat format) {
        Layout layout = new Layout(page);
        layout.place();
        layout.readAxes();
        layout.compare(panels);
        panels.stream().flatMap(panel -> panel.charts().stream()).flatMap(chart -> chart.rows().stream())
                .filter(row -> layout.texts.stream().noneMatch(text -> text.text().equals(row)))
                .forEach(row -> layout.faults.add("the row '" + row + "' has no label"));
        if (format.slide()) {
            layout.texts.stream().filter(text -> text.size() < TYPE * page.height())
                    .forEach(text -> layout.faults.add(text.text() + ": type of " + text.size()));
        }
        if (panels.stream().anyMatch(panel -> panel.title().isBlank())) {
            layout.faults.add("no title");
        }
        return layout.faults;
    }

    /** @return the first line of text on a page, which is the begin of its title */
    public static String firstLine(ChartPage page) {
        return new PageRecorder(page).texts().get(0).text();
    }

    private void place() {
        Rectangle2D all = new Rectangle2D.Double(0, 0, page.width(), page.height());
        for (int k = 0; k < texts.size(); k++) {
            Rectangle2D box = texts.get(k).box();
            if (!all.contains(box)) {
                faults.add(say(texts.get(k)) + " leaves the page");
            }
            for (Text other : texts.subList(k + 1, texts.size())) {
                if (overlap(box, other.box())) {
                    faults.add(say(texts.get(k)) + " runs into " + say(other));
                }
            }
            for (Rectangle2D panel : panels) {
                if (overlap(box, panel) && !grown(panel).contains(box)) {
                    faults.add(say(texts.get(k)) + " crosses the frame of a panel");
                }
            }
            if (panels.stream().anyMatch(panel -> recorder.ends().stream().anyMatch(end -> panel.contains(end)
                    && box.intersects(end.getX() - END, end.getY() - END, 2 * END, 2 * END)))) {
                faults.add(say(texts.get(k)) + " covers the end of a curve");
            }
            if (recorder.leaders().stream().anyMatch(line -> line.intersects(box))) {
                faults.add(say(texts.get(k)) + " covers the line to a name");
            }
        }
        for (int k = 0; k < panels.size(); k++) {
            Rectangle2D panel = panels.get(k);
            if (!all.contains(panel) || panels.subList(k + 1, panels.size()).stream()
                    .anyMatch(other -> overlap(panel, other) && !panel.equals(other))) {
                faults.add("a panel leaves the page or covers another: " + panel);
            }
        }
    }

    private static Rectangle2D grown(Rectangle2D box) {
        return new Rectangle2D.Double(box.getX() - TOUCH, box.getY() - TOUCH, box.getWidth() + 2 * TOUCH,
                box.getHeight() + 2 * TOUCH);
    }

    private static String say(Text text) {
        Rectangle2D box = text.box();
        return "'%s' (%.0f, %.0f to %.0f, %.0f)".formatted(text.text(), box.getMinX(), box.getMinY(), box.getMaxX(),
                box.getMaxY());
    }

    private static boolean overlap(Rectangle2D a, Rectangle2D b) {
        return a.getMaxX() > b.getMinX() + TOUCH && b.getMaxX() > a.getMinX() + TOUCH
                && a.getMaxY() > b.getMinY() + TOUCH && b.getMaxY() > a.getMinY() + TOUCH;
    }

    private void readAxes() {
        if (panels.isEmpty()) {
            faults.add("no panel");
        }
        for (Rectangle2D panel : panels) {
            List<Text> beside = texts.stream().filter(text -> text.isTick()
                    && text.box().getCenterY() > panel.getMinY() - TOUCH
                    && text.box().getCenterY() < panel.getMaxY() + TOUCH
                    && Math.abs(panel.getMinX() - text.box().getMaxX()) < NEAR).toList();
            if (beside.stream().allMatch(Text::isNumber)) {
                count(beside, "beside " + panel);
            }
            boolean carriesAxis = panels.stream().noneMatch(other -> other.getMinX() == panel.getMinX()
                    && other.getMinY() > panel.getMaxY() && other.getMinY() < panel.getMaxY() + 2 * NEAR);
            if (carriesAxis) {
                count(texts.stream().filter(text -> text.isTick()
                        && text.box().getCenterX() > panel.getMinX() - TOUCH
                        && text.box().getCenterX() < panel.getMaxX() + TOUCH
                        && Math.abs(text.box().getMinY() - panel.getMaxY()) < NEAR).toList(), "below " + panel);
            }
        }
    }

    private void count(List<Text> labels, String where) {
        if (labels.size() < LABELS) {
            faults.add("only " + labels.stream().map(Text::text).collect(Collectors.toList()) + " " + where);
        }
    }

    /**
     * Panels of the same quantities have the same scale, and frames of the same size; those with arrows keep the scale
     * of their slides.
     */
    private void compare(List<Panel> charts) {
        if (charts.isEmpty()) {
            return;                                     // a race: pictures of its scene
        }
        Chart first = charts.get(0).charts().get(0);
        if (charts.stream().map(panel -> panel.charts().get(0)).allMatch(chart -> chart.x().equals(first.x())
                && chart.y().equals(first.y()) && chart.rows().isEmpty())
                && charts.stream().allMatch(panel -> panel.field().isEmpty())
                && Stream.of(true, false).anyMatch(x -> charts.stream().map(panel ->
                ChartPlot.shown(panel.charts().get(0), x)).distinct().count() > 1)) {
            faults.add("panels of " + first.y() + " over " + first.x() + " differ in scale");
        }
        boolean equal = charts.size() > 1 && charts.stream().allMatch(panel -> panel.charts().get(0).scale().equals(
                first.scale()) && panel.charts().get(0).rows().isEmpty());
        if (equal) {
            List<Rectangle2D> main = panels.stream().filter(panel -> panels.stream().noneMatch(other ->
                    other.getMinX() == panel.getMinX() && other.getMaxY() < panel.getMinY()
                    && other.getMaxY() > panel.getMinY() - 2 * NEAR)).toList();
            for (Rectangle2D panel : main) {
                if (Math.abs(panel.getWidth() / main.get(0).getWidth() - 1) > EQUAL
                        || Math.abs(panel.getHeight() / main.get(0).getHeight() - 1) > EQUAL) {
                    faults.add("panels that are compared differ in size: " + panel + " and " + main.get(0));
                }
            }
        }
    }
}
