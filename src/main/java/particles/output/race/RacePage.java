package particles.output.race;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import particles.output.charts.ChartStyle;
import particles.output.charts.SolverStyle;
import particles.output.charts.StripChart;
import particles.output.text.FontCheck;

/**
 * A picture of a race: a title and the time, panels in a grid, and a chart in the free cells or below.
 *
 * @param width       the width of the picture (pixels)
 * @param height      its height
 * @param columns     the number of panels in a row
 * @param panelWidth  the width of a panel
 * @param panelHeight its height
 * @param strip       the rectangle of the chart
 */
record RacePage(int width, int height, int columns, int panelWidth, int panelHeight, Rectangle2D strip) {
    private static final int WIDTH = 1000;
    private static final int SHEET_WIDTH = 960;
    private static final int SHEET_HEIGHT = 540;
    private static final int WIDEST = 640;
    private static final int LEAST_STRIP = 170;
    private static final int GAP = 8;
    private static final int HEAD = 72;
    private static final int CLOCK_WIDTH = 130;
    /** The height of the two lines above a panel. */
    private static final int LABEL = 38;
    private static final float LEAST_TYPE = 8;
    private static final int SMALL_PANEL = 220;
    private static final int STRIP = 230;
    private static final Color GONE = new Color(255, 255, 255, 120);
    private static final Font TITLE = FontCheck.font(Font.BOLD, 17);
    private static final Font CLOCK = FontCheck.font(Font.PLAIN, 17);
    private static final Font FINDING = FontCheck.font(Font.PLAIN, 14);
    private static final Font SMALL = FontCheck.font(Font.PLAIN, 12);
    private static final Font NAME = FontCheck.font(Font.BOLD, 13);

    /**
     * @param panels the number of panels
     * @param aspect the width of each divided by its height
     * @return the page of a film; its height is even, as films need it
     */
    static RacePage ofFilm(int panels, double aspect) {
        int columns = columns(panels);
        int wide = Math.min(WIDEST, (WIDTH - (columns + 1) * GAP) / columns);
        int high = (int) Math.max(wide / 2.5, Math.min(wide, wide / aspect));
        int all = bottom(panels, high) + (panels % columns > 0 ? 0 : STRIP);
        return of(WIDTH, (all + 1) / 2 * 2, panels, wide, high);
    }

    /** @return a page of 16:9 for the same panels */
    RacePage sheet(int panels) {
        int rows = (panels + columns - 1) / columns;
        int most = (SHEET_HEIGHT - HEAD - (panels % columns > 0 ? 0 : LEAST_STRIP)) / rows - LABEL - GAP;
        int wide = Math.min((SHEET_WIDTH - (columns + 1) * GAP) / columns, most * panelWidth / panelHeight);
        return of(SHEET_WIDTH, SHEET_HEIGHT, panels, wide, wide * panelHeight / panelWidth);
    }

    /** A page of this size, with the chart in the free cells of the last row, or below if there are none. */
    private static RacePage of(int width, int height, int panels, int wide, int high) {
        int columns = columns(panels);
        int bottom = bottom(panels, high);
        int left = GAP + panels % columns * pitch(width, columns);
        return new RacePage(width, height, columns, wide, high, panels % columns == 0
                ? new Rectangle2D.Double(0, bottom, width, height - bottom)
                : new Rectangle2D.Double(left, bottom - GAP - high - LABEL, width - left, high + LABEL));
    }

    /** Up to three panels are in one row; most other numbers leave a cell free. */
    private static int columns(int panels) {
        return panels <= 3 ? panels : (int) Math.ceil(Math.sqrt(panels + 1));
    }

    private static int bottom(int panels, int high) {
        return HEAD + (panels + columns(panels) - 1) / columns(panels) * (LABEL + high + GAP);
    }

    /** @return an empty picture of a panel's size */
    BufferedImage panel() {
        return new BufferedImage(panelWidth, panelHeight, BufferedImage.TYPE_INT_RGB);
    }

    /** From a panel to the next; the text above each may be wider than the panel. */
    private static int pitch(int width, int columns) {
        return (width - GAP) / columns;
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
        g.fillRect(0, 0, width, height);
        // the equal budget, with room for the clock, and below it the winner and the ghost
        g.setColor(ChartStyle.TEXT);
        drawFitting(g, TITLE, head.title(), GAP, 24, width - CLOCK_WIDTH - 2 * GAP);
        drawFitting(g, FINDING, head.finding(), GAP, 45, width - 2 * GAP);
        g.setColor(ChartStyle.AXIS);
        drawFitting(g, SMALL, head.ghost(), GAP, 63, width - 2 * GAP);
        g.setFont(CLOCK);
        g.setColor(ChartStyle.TEXT);
        g.drawString(String.format(Locale.ROOT, "t = %.2f s", time),
                width - GAP - g.getFontMetrics().stringWidth("t = 0000.00 s"), 24);
        for (int k = 0; k < panels.size(); k++) {
            int x = GAP + k % columns * pitch(width, columns);
            int y = HEAD + k / columns * (LABEL + panelHeight + GAP);
            drawLabel(g, head.words().get(k), x, y);
            g.drawImage(panels.get(k), x, y + LABEL, panelWidth, panelHeight, null);
            drawFrame(g, new Rectangle2D.Double(x, y + LABEL, panelWidth, panelHeight), head.words().get(k).left(),
                    time);
        }
        chart.draw(g, strip, time);
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
        SolverStyle look = SolverStyle.orGrey(words.name());
        g.setColor(look.colour());
        g.setStroke(look.stroke());
        g.draw(new Line2D.Double(x + 2, y + 12, x + 34, y + 12));
        g.translate(x + 18, y + 12);
        g.fill(look.shape());
        g.translate(-x - 18, -y - 12);
        g.setColor(ChartStyle.TEXT);
        drawFitting(g, NAME, words.name(), x + 40, y + 17, pitch(width, columns) - GAP - 40);
        g.setColor(ChartStyle.AXIS);
        drawFitting(g, SMALL, words.text(), x + 2, y + 32, pitch(width, columns) - GAP - 2);
    }

    /** A run that has left the race stays visible, faint, with the time at which it left. */
    private static void drawFrame(Graphics2D g, Rectangle2D area, OptionalDouble left, double time) {
        if (left.isPresent() && time >= left.getAsDouble()) {
            g.setColor(GONE);
            g.fill(area);
            String text = String.format(Locale.ROOT, "left at t = %.3g s", left.getAsDouble());
            g.setFont(area.getWidth() > SMALL_PANEL ? NAME : SMALL);
            double width = g.getFontMetrics().stringWidth(text) + 36.0;
            RoundRectangle2D box = new RoundRectangle2D.Double(area.getCenterX() - width / 2, area.getMaxY() - 40,
                    width,
                    26, 8, 8);
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
