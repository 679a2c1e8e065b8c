package particles.output.race;

import java.awt.Color;
import java.awt.Font;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
import particles.output.charts.ChartStyle;
import particles.output.charts.ChartWriter;
import particles.output.charts.StripChart;
import particles.output.text.FontCheck;

/**
 * A race as a still of 16:9: a column a run, with its picture at some moments below each other, and the chart with
 * these moments below. Many runs stand in two rows, as they are at the end.
 */
final class RaceSheet {
    private static final int MOST_COLUMNS = 6;
    private static final int MOMENTS = 2;
    private static final int WIDTH = 960;
    private static final int HEIGHT = 540;
    private static final int GAP = 6;
    private static final int HEAD = 68;
    private static final int TIME = 14;
    private static final int LEAST_STRIP = 130;
    private static final Font TIMES = FontCheck.font(Font.PLAIN, 11);

    private RaceSheet() {
    }

    /**
     * @param runs how many there are
     * @param last the index of the last frame
     * @return the frames that are shown: after equal parts of the time, the last one at the end
     */
    static int[] moments(int runs, int last) {
        return runs > MOST_COLUMNS ? new int[] {last} : new int[] {last / MOMENTS, last};
    }

    /**
     * @param writer  where it goes
     * @param name    the file's name
     * @param head    at the top
     * @param moments from {@link #moments}
     * @param words   for each run
     * @param panels  each run's picture at a frame
     * @param chart   below
     * @param rate    frames a second (1/s)
     */
    static void write(ChartWriter writer, String name, RaceFilm.Head head, int[] moments, List<RaceFilm.Words> words,
                      IntFunction<List<BufferedImage>> panels, StripChart chart, double rate) {
        List<List<BufferedImage>> pictures = Arrays.stream(moments).mapToObj(panels).toList();
        BufferedImage one = pictures.get(0).get(0);
        int rows = words.size() > MOST_COLUMNS ? MOMENTS : 1;
        int columns = (words.size() + rows - 1) / rows;
        int labels = rows * RacePage.LABEL + moments.length * TIME;
        int most = (HEIGHT - HEAD - LEAST_STRIP - labels) / MOMENTS - GAP;
        int width = (WIDTH - (columns + 1) * GAP) / columns;
        width = Math.min(width, most * one.getWidth() / one.getHeight());
        int height = width * one.getHeight() / one.getWidth();
        int moment = TIME + height + GAP;
        int row = RacePage.LABEL + moments.length * moment;
        int beside = (WIDTH - columns * (width + GAP) + GAP) / 2;
        int size = width;
        double[] times = Arrays.stream(moments).mapToDouble(index -> index / rate).toArray();
        writer.write(name, WIDTH, HEIGHT, g -> {
            RacePage.smooth(g);
            g.setColor(Color.WHITE);
            g.fillRect(0, 0, WIDTH, HEIGHT);
            RacePage.drawHead(g, head, WIDTH);
            for (int k = 0; k < words.size(); k++) {
                int x = beside + k % columns * (size + GAP);
                int y = HEAD + k / columns * row;
                RacePage.drawLabel(g, words.get(k), x, y, size);
                for (int m = 0; m < moments.length; m++) {
                    int top = y + RacePage.LABEL + m * moment;
                    g.setFont(TIMES);
                    g.setColor(ChartStyle.TEXT);
                    g.drawString(String.format(Locale.ROOT, "t = %.2f s", times[m]), x + 2, top + TIME - 4);
                    RacePage.drawPanel(g, pictures.get(m).get(k), new Rectangle2D.Double(x, top + TIME, size, height),
                            words.get(k).left(), times[m]);
                }
            }
            int bottom = HEAD + rows * row;
            chart.draw(g, new Rectangle2D.Double(0, bottom, WIDTH, HEIGHT - bottom), times);
        });
    }
}
