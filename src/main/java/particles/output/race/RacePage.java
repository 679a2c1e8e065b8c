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

/** A picture of a race: a title and the time, panels in a grid, and a chart in the free cells or below. */
final class RacePage {
    private static final int WIDTH = 1000;
    private static final int GAP = 8;
    private static final int HEAD = 72;
    private static final int CLOCK_WIDTH = 130;
    /** The height of the two lines above a panel. */
    static final int LABEL = 38;
    private static final float LEAST_TYPE = 8;
    private static final int SMALL_PANEL = 220;
    private static final int STRIP = 230;
    private static final Color GONE = new Color(255, 255, 255, 120);
    private static final Font TITLE = FontCheck.font(Font.BOLD, 17);
    private static final Font CLOCK = FontCheck.font(Font.PLAIN, 17);
    private static final Font FINDING = FontCheck.font(Font.PLAIN, 14);
    private static final Font SMALL = FontCheck.font(Font.PLAIN, 12);
    private static final Font NAME = FontCheck.font(Font.BOLD, 13);

    private final int panels;
    private final int columns;
    private final int rows;
    private final int panelWidth;
    private final int panelHeight;

    RacePage(int panels, double aspect) {
        this.panels = panels;
        columns = panels <= 3 ? panels : (int) Math.ceil(Math.sqrt(panels));
        rows = (panels + columns - 1) / columns;
        panelWidth = Math.min(640, (WIDTH - (columns + 1) * GAP) / columns);
        panelHeight = (int) Math.max(panelWidth / 2.5, Math.min(panelWidth, panelWidth / aspect));
    }

    int getPanelWidth() {
        return panelWidth;
    }

    int getPanelHeight() {
        return panelHeight;
    }

    int width() {
        return WIDTH;
    }

    /** The height of the page; even, as films need it. */
    int height() {
        return (HEAD + rows * (LABEL + panelHeight + GAP) + (free() > 0 ? 0 : STRIP) + 1) / 2 * 2;
    }

    /** The number of grid cells without a panel. */
    private int free() {
        return rows * columns - panels;
    }

    /**
     * @param image  the image to draw on
     * @param head   the text at the top
     * @param time   the present time (s)
     * @param words  the text for each panel
     * @param panels the pictures
     * @param chart  the chart below them
     */
    void draw(BufferedImage image, RaceFilm.Head head, double time, List<BufferedImage> panels, StripChart chart) {
        Graphics2D g = image.createGraphics();
        smooth(g);
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        drawHead(g, head, WIDTH);
        g.setFont(CLOCK);
        String clock = String.format(Locale.ROOT, "t = %.2f s", time);
        g.setColor(ChartStyle.TEXT);
        g.drawString(clock, WIDTH - GAP - g.getFontMetrics().stringWidth("t = 0000.00 s"), 24);
        int beside = (WIDTH - columns * panelWidth - (columns - 1) * GAP) / 2;
        for (int k = 0; k < panels.size(); k++) {
            int x = beside + k % columns * (panelWidth + GAP);
            int y = HEAD + k / columns * (LABEL + panelHeight + GAP);
            drawLabel(g, head.words().get(k), x, y, panelWidth);
            drawPanel(g, panels.get(k), new Rectangle2D.Double(x, y + LABEL, panelWidth, panelHeight),
                    head.words().get(k).left(), time);
        }
        int left = beside + (columns - free()) * (panelWidth + GAP);
        chart.draw(g, free() == 0 ? new Rectangle2D.Double(0, height() - STRIP, WIDTH, STRIP)
                : new Rectangle2D.Double(left, height() - GAP - panelHeight - LABEL, WIDTH - left,
                panelHeight + LABEL), time);
        g.dispose();
    }

    static void smooth(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    /** Draws the head: the equal budget, with room for the clock, and below it the winner and the ghost. */
    static void drawHead(Graphics2D g, RaceFilm.Head head, int width) {
        g.setColor(ChartStyle.TEXT);
        drawFitting(g, TITLE, head.title(), 24, width - CLOCK_WIDTH);
        drawFitting(g, FINDING, head.finding(), 45, width);
        g.setColor(ChartStyle.AXIS);
        drawFitting(g, SMALL, head.ghost(), 63, width);
    }

    /** Draws text as large as it fits. */
    private static void drawFitting(Graphics2D g, Font largest, String text, int y, int width) {
        drawFitting(g, largest, text, GAP, y, width - 2 * GAP);
    }

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
    static void drawLabel(Graphics2D g, RaceFilm.Words words, int x, int y, int width) {
        SolverStyle look = SolverStyle.orGrey(words.name());
        g.setColor(look.colour());
        g.setStroke(look.stroke());
        g.draw(new Line2D.Double(x + 2, y + 12, x + 34, y + 12));
        g.translate(x + 18, y + 12);
        g.fill(look.shape());
        g.translate(-x - 18, -y - 12);
        g.setColor(ChartStyle.TEXT);
        drawFitting(g, NAME, words.name(), x + 40, y + 17, width - 40);
        g.setColor(ChartStyle.AXIS);
        drawFitting(g, SMALL, words.step() + ", " + words.cost(), x + 2, y + 32, width - 4);
    }

    /** Draws a panel. A run that has left the race stays visible, faint, with the time at which it left. */
    static void drawPanel(Graphics2D g, BufferedImage panel, Rectangle2D area, OptionalDouble left, double time) {
        g.drawImage(panel, (int) area.getX(), (int) area.getY(), (int) area.getWidth(), (int) area.getHeight(), null);
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
