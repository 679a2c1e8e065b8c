package particles.output;

import java.awt.Color;
import java.awt.Font;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;

/** A race on paper: a row a run, its picture at some moments beside each other, and the chart with these moments below. */
final class RaceSheet {
    /** How many moments there are. */
    static final int MOMENTS = 4;
    private static final int WIDTH = 1000;
    private static final int GAP = 8;
    private static final int HEAD = 96;
    private static final int LABEL = 22;
    private static final int STRIP = 250;
    private static final Font TIME = Lettering.font(Font.PLAIN, 13);

    private RaceSheet() {
    }

    /**
     * @param folder  where it goes
     * @param name    the file's name
     * @param head    at the top
     * @param moments indices of frames
     * @param words   for each run
     * @param panels  each run's picture at a frame
     * @param chart   below
     * @param rate    frames a second (1/s)
     */
    static void write(OutputFolder folder, String name, RaceFilm.Head head, int[] moments, List<RaceFilm.Words> words,
                      IntFunction<List<BufferedImage>> panels, StripChart chart, double rate) {
        Lettering.require(folder.getPath().resolve(name));
        List<List<BufferedImage>> pictures = Arrays.stream(moments).mapToObj(panels).toList();
        BufferedImage one = pictures.get(0).get(0);
        int width = (WIDTH - (MOMENTS + 1) * GAP) / MOMENTS;
        int height = width * one.getHeight() / one.getWidth();
        int row = LABEL + height + GAP;
        int bottom = HEAD + words.size() * row;
        double[] times = Arrays.stream(moments).mapToDouble(index -> index / rate).toArray();
        ChartWriter.write(folder, name, WIDTH, bottom + STRIP, g -> {
            RacePage.smooth(g);
            g.setColor(Color.WHITE);
            g.fillRect(0, 0, WIDTH, bottom + STRIP);
            RacePage.drawHead(g, head, WIDTH);
            for (int m = 0; m < MOMENTS; m++) {
                int x = GAP + m * (width + GAP);
                g.setFont(TIME);
                g.setColor(ChartStyle.TEXT);
                g.drawString(String.format(Locale.ROOT, "t = %.2f s", times[m]), x, HEAD - 6);
                for (int k = 0; k < words.size(); k++) {
                    int y = HEAD + k * row;
                    if (m == 0) {
                        RacePage.drawLabel(g, words.get(k), GAP, y, WIDTH - 2 * GAP);
                    }
                    RacePage.drawPanel(g, pictures.get(m).get(k), new Rectangle2D.Double(x, y + LABEL, width, height),
                            words.get(k).left(), times[m]);
                }
            }
            chart.draw(g, new Rectangle2D.Double(0, bottom, WIDTH, STRIP), times);
        });
    }
}
