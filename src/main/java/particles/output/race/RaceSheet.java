package particles.output.race;

import java.awt.Color;
import java.awt.Font;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import particles.output.charts.ChartStyle;
import particles.output.charts.ChartWriter;
import particles.output.charts.StripChart;
import particles.output.files.OutputFolder;
import particles.output.text.FontCheck;

/**
 * A race on paper: a row a run, its picture at some moments beside each other, and the chart with these moments below.
 * Many runs stand in two columns, with half the moments.
 */
final class RaceSheet {
    /** How many pictures stand beside each other. */
    private static final int PICTURES = 4;
    private static final int MOST_ROWS = 5;
    private static final int WIDTH = 1000;
    private static final int GAP = 8;
    private static final int HEAD = 96;
    private static final int LABEL = 22;
    private static final int STRIP = 250;
    private static final Font TIME = FontCheck.font(Font.PLAIN, 13);

    private RaceSheet() {
    }

    /**
     * @param runs how many there are
     * @param last the index of the last frame
     * @return the frames that are shown: after equal parts of the time, the last one at the end
     */
    static int[] moments(int runs, int last) {
        int count = runs > MOST_ROWS ? PICTURES / 2 : PICTURES;
        return IntStream.rangeClosed(1, count).map(k -> k * last / count).toArray();
    }

    /**
     * @param folder  where it goes
     * @param name    the file's name
     * @param head    at the top
     * @param moments from {@link #moments}
     * @param words   for each run
     * @param panels  each run's picture at a frame
     * @param chart   below
     * @param rate    frames a second (1/s)
     */
    static void write(OutputFolder folder, String name, RaceFilm.Head head, int[] moments, List<RaceFilm.Words> words,
                      IntFunction<List<BufferedImage>> panels, StripChart chart, double rate) {
        FontCheck.require(folder.getPath().resolve(name));
        List<List<BufferedImage>> pictures = Arrays.stream(moments).mapToObj(panels).toList();
        BufferedImage one = pictures.get(0).get(0);
        int columns = PICTURES / moments.length;
        int rows = (words.size() + columns - 1) / columns;
        int width = (WIDTH - (PICTURES + 1) * GAP) / PICTURES;
        int height = width * one.getHeight() / one.getWidth();
        int row = LABEL + height + GAP;
        int bottom = HEAD + rows * row;
        double[] times = Arrays.stream(moments).mapToDouble(index -> index / rate).toArray();
        ChartWriter.write(folder, name, WIDTH, bottom + STRIP, g -> {
            RacePage.smooth(g);
            g.setColor(Color.WHITE);
            g.fillRect(0, 0, WIDTH, bottom + STRIP);
            RacePage.drawHead(g, head, WIDTH);
            for (int k = 0; k < words.size(); k++) {
                int left = GAP + k / rows * moments.length * (width + GAP);
                int y = HEAD + k % rows * row;
                RacePage.drawLabel(g, words.get(k), left, y, moments.length * (width + GAP) - GAP);
                for (int m = 0; m < moments.length; m++) {
                    int x = left + m * (width + GAP);
                    if (k % rows == 0) {
                        g.setFont(TIME);
                        g.setColor(ChartStyle.TEXT);
                        g.drawString(String.format(Locale.ROOT, "t = %.2f s", times[m]), x, HEAD - 6);
                    }
                    RacePage.drawPanel(g, pictures.get(m).get(k), new Rectangle2D.Double(x, y + LABEL, width, height),
                            words.get(k).left(), times[m]);
                }
            }
            chart.draw(g, new Rectangle2D.Double(0, bottom, WIDTH, STRIP), times);
        });
    }
}
