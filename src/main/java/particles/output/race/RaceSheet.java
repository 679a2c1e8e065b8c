package particles.output.race;

import java.awt.Color;
import java.awt.Font;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import particles.output.charts.ChartPage;
import particles.output.charts.ChartStyle;
import particles.output.charts.ChartWriter;
import particles.output.charts.StripChart;
import particles.output.text.FontCheck;

/**
 * The still of 16:9 that shows the end of a race: the runs beside each other, in two rows if there are many, with the
 * chart below.
 */
final class RaceSheet {
    private static final int MOST_COLUMNS = 6;
    private static final int WIDTH = 960;
    private static final int HEIGHT = 540;
    private static final int GAP = 8;
    private static final int HEAD = 72;
    private static final int LEAST_STRIP = 170;
    private static final Font TIME = FontCheck.font(Font.PLAIN, 14);

    private RaceSheet() {
    }

    /**
     * @param writer writes the picture
     * @param name   the file's name
     * @param head   the text at the top
     * @param words  the text for each run
     * @param panels the picture of each run at the end
     * @param chart  the chart below
     * @param time   the time at the end (s)
     */
    static void write(ChartWriter writer, String name, RaceFilm.Head head, List<BufferedImage> panels,
            StripChart chart, double time) {
        List<RaceFilm.Words> words = head.words();
        BufferedImage one = panels.get(0);
        int rows = words.size() > MOST_COLUMNS ? 2 : 1;
        int columns = (words.size() + rows - 1) / rows;
        int most = (HEIGHT - HEAD - LEAST_STRIP) / rows - RacePage.LABEL - GAP;
        int width = Math.min((WIDTH - (columns + 1) * GAP) / columns, most * one.getWidth() / one.getHeight());
        int height = width * one.getHeight() / one.getWidth();
        int beside = (WIDTH - columns * (width + GAP) + GAP) / 2;
        int bottom = HEAD + rows * (RacePage.LABEL + height + GAP);
        writer.onWhite().write(name, new ChartPage(WIDTH, HEIGHT, g -> {
            RacePage.smooth(g);
            g.setColor(Color.WHITE);
            g.fillRect(0, 0, WIDTH, HEIGHT);
            RacePage.drawHead(g, head, WIDTH);
            g.setFont(TIME);
            g.setColor(ChartStyle.TEXT);
            String clock = String.format(Locale.ROOT, "t = %.2f s", time);
            g.drawString(clock, WIDTH - GAP - g.getFontMetrics().stringWidth(clock), 24);
            for (int k = 0; k < words.size(); k++) {
                int x = beside + k % columns * (width + GAP);
                int y = HEAD + k / columns * (RacePage.LABEL + height + GAP);
                RacePage.drawLabel(g, words.get(k), x, y, width);
                RacePage.drawPanel(g, panels.get(k), new Rectangle2D.Double(x, y + RacePage.LABEL, width, height),
                        words.get(k).left(), time);
            }
            chart.draw(g, new Rectangle2D.Double(0, bottom, WIDTH, HEIGHT - bottom));
        }));
    }
}
