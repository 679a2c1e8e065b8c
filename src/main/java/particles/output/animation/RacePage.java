package particles.output.animation;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import particles.output.charts.ChartStyle;
import particles.output.charts.StripChart;
import particles.output.files.FontCheck;

/**
 * A picture of a race, 16:9: a title and the time, panels in a grid, and a chart in the free cells or below.
 *
 * @param columns     the number of panels in a row
 * @param panelWidth  the width of a panel
 * @param panelHeight its height
 * @param strip       the rectangle of the chart
 */
record RacePage(int columns, int panelWidth, int panelHeight, Rectangle2D strip) {
    static final int WIDTH = 960;
    static final int HEIGHT = 540;
    /** The places and sizes of panels are multiples of it: so many pixels of the page are 4 pixels of the film. */
    private static final int UNIT = 3;
    private static final int MOST_COLUMNS = 6;
    /** A frame has at least 16 pixels in each direction. */
    private static final int LEAST = 4;
    /** Two panels fill a row above the chart. */
    private static final double WIDEST = 2.1;
    private static final int STRIP = 200;
    private static final int GAP = 9;
    private static final int HEAD = 72;
    private static final int CLOCK_WIDTH = 130;
    /** The height of the two lines above a panel. */
    private static final int LABEL = 39;
    private static final float LEAST_TYPE = 8;
    private static final int SMALL_PANEL = 220;
    private static final Color GONE = new Color(255, 255, 255, 120);
    private static final Font TITLE = FontCheck.font(Font.BOLD, 17);
    private static final Font CLOCK = FontCheck.font(Font.PLAIN, 17);
    private static final Font NOTE = FontCheck.font(Font.PLAIN, 14);
    private static final Font SMALL = FontCheck.font(Font.PLAIN, 12);
    private static final Font NAME = FontCheck.font(Font.BOLD, 13);

    /**
     * @param panels the number of panels
     * @param aspect the width of each divided by its height
     * @return the page with the widest panels; the chart is in the free cells of the last row, or below if there are
     *         none
     */
    static RacePage of(int panels, double aspect) {
        int columns = columns(panels, aspect);
        double width = width(panels, columns, aspect);
        int high = whole(width / aspect);
        int beside = panels % columns;
        int left = beside == 0 ? 0 : GAP + beside * pitch(columns);
        int top = HEAD + panels / columns * (LABEL + high + GAP);
        return new RacePage(columns, whole(width), high,
                new Rectangle2D.Double(left, top, WIDTH - left, HEIGHT - top));
    }

    /** @return the width of a panel that fills its cell divided by its height */
    static double aspect(int panels) {
        int columns = columns(panels, WIDEST);
        return Math.min(WIDEST, (pitch(columns) - GAP) / (double) highest(panels, columns));
    }

    /** One column more than there are panels leaves a cell for the chart; more than six have no room for words. */
    private static int columns(int panels, double aspect) {
        return IntStream.rangeClosed(1, Math.min(panels + 1, MOST_COLUMNS)).boxed()
                .max(Comparator.comparingDouble(columns -> width(panels, columns, aspect))).orElseThrow();
    }

    private static double width(int panels, int columns, double aspect) {
        return Math.min(pitch(columns) - GAP, aspect * highest(panels, columns));
    }

    private static int whole(double length) {
        return Math.max(LEAST, (int) Math.round(length / UNIT)) * UNIT;
    }

    private static int highest(int panels, int columns) {
        int rows = (panels + columns - 1) / columns;
        return (HEIGHT - HEAD - (panels % columns > 0 ? 0 : STRIP)) / rows - LABEL - GAP;
    }

    /** From a panel to the next; the text above each may be wider than the panel. */
    private static int pitch(int columns) {
        return (WIDTH - GAP) / columns / UNIT * UNIT;
    }

    /**
     * @param g      the graphics to draw on
     * @param head   the text at the top and beside each panel
     * @param time   the present time (s)
     * @param panels the pictures
     * @param chart  the chart
     */
    void draw(Graphics2D g, RaceFilm.Head head, double time, List<BufferedImage> panels, StripChart chart) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        g.setColor(ChartStyle.TEXT);
        drawFitting(g, TITLE, head.title(), GAP, 24, WIDTH - CLOCK_WIDTH - 2 * GAP);
        g.setColor(ChartStyle.AXIS);
        drawFitting(g, NOTE, head.ghost(), GAP, 50, WIDTH - 2 * GAP);
        g.setFont(CLOCK);
        g.setColor(ChartStyle.TEXT);
        g.drawString(String.format(Locale.ROOT, "t = %.2f s", time),
                WIDTH - GAP - g.getFontMetrics().stringWidth("t = 0000.00 s"), 24);
        for (int k = 0; k < panels.size(); k++) {
            int x = GAP + k % columns * pitch(columns);
            int y = HEAD + k / columns * (LABEL + panelHeight + GAP);
            drawLabel(g, head.words().get(k), x, y);
            g.drawImage(panels.get(k), x, y + LABEL, panelWidth, panelHeight, null);
            drawFrame(g, new Rectangle2D.Double(x, y + LABEL, panelWidth, panelHeight), head.words().get(k).left(),
                    time);
        }
        double size = Math.min(1, strip.getHeight() / STRIP);      // small type, or the name of its axis would be cut
        g.scale(size, size);
        chart.draw(g, new Rectangle2D.Double(strip.getX() / size, strip.getY() / size, strip.getWidth() / size,
                strip.getHeight() / size), time);
        g.scale(1 / size, 1 / size);
    }

    /** Draws text as large as it fits. */
    private static void drawFitting(Graphics2D g, Font largest, String text, int x, int y, int width) {
        Font font = largest;
        g.setFont(font);
        while (g.getFontMetrics().stringWidth(text) > width && font.getSize2D() > LEAST_TYPE) {
            font = font.deriveFont(font.getSize2D() - 1);
            g.setFont(font);
        }
        g.drawString(text, x, y);
    }

    /** Draws the label of a panel: the solver's line, as in the chart, and its name; below, its step and its work. */
    private void drawLabel(Graphics2D g, RaceFilm.Words words, int x, int y) {
        g.setColor(new Color(words.look().rgb()));
        g.setStroke(ChartStyle.stroke(words.look().variant()));
        g.draw(new Line2D.Double(x + 2, y + 12, x + 34, y + 12));
        g.translate(x + 18, y + 12);
        g.fill(ChartStyle.shape(words.look().variant()));
        g.translate(-x - 18, -y - 12);
        g.setColor(ChartStyle.TEXT);
        drawFitting(g, NAME, words.name() + "  " + words.answer(), x + 40, y + 17, pitch(columns) - GAP - 40);
        g.setColor(ChartStyle.AXIS);
        drawFitting(g, SMALL, words.text(), x + 2, y + 32, pitch(columns) - GAP - 2);
    }

    /** A run that has left the race stays visible, faint, with the time at which it left. */
    private static void drawFrame(Graphics2D g, Rectangle2D area, OptionalDouble left, double time) {
        if (left.isPresent() && time >= left.getAsDouble()) {
            g.setColor(GONE);
            g.fill(area);
            String text = String.format(Locale.ROOT, "left the race at t = %.3g s", left.getAsDouble());
            g.setFont(area.getWidth() > SMALL_PANEL ? NAME : SMALL);
            double width = g.getFontMetrics().stringWidth(text) + 36.0;
            RoundRectangle2D box = new RoundRectangle2D.Double(area.getCenterX() - width / 2, area.getMaxY() - 40,
                    width, 26, 8, 8);
            g.setColor(Color.WHITE);
            g.fill(box);
            g.setColor(Color.RED.darker());
            g.setStroke(new BasicStroke(1));
            g.draw(box);
            g.translate(box.getX() + 15, box.getCenterY());
            g.fill(ChartStyle.FAILURE);
            g.translate(-box.getX() - 15, -box.getCenterY());
            g.drawString(text, (float) box.getX() + 26, (float) box.getY() + 18);
        }
        g.setColor(ChartStyle.GRID);
        g.setStroke(new BasicStroke(1));
        g.draw(area);
    }
}
