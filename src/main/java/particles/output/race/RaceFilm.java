package particles.output.race;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import particles.Observer;
import particles.output.animation.GifAnimation;
import particles.output.charts.ChartWriter;
import particles.output.charts.SolverStyle;
import particles.output.charts.StripChart;
import particles.output.frames.FrameSetup;
import particles.output.frames.Pipeline;
import particles.view.ChartData;

/**
 * The film of a race: the runs of several solvers beside each other, each over the translucent ghost of the reference,
 * with a chart over the same time below. The runs are recorded one after the other, then the film is written.
 */
public final class RaceFilm implements AutoCloseable {
    /** The grey of the ghost. */
    private static final int GREY = 0x6f747c;
    /** A page, its panels and its copies for the file. */
    private static final long BYTES_PER_PIXEL = 20;

    private final RacePage page;
    private final double rate;
    private final double playback;
    private final List<PanelFilm> films = new ArrayList<>();
    private PanelFilm ghost;

    /** What one thread draws on; a chart cannot be drawn by two threads at a time. */
    private record Canvas(BufferedImage image, StripChart chart) {
        Canvas(RacePage page, ChartData strip) {
            this(new BufferedImage(page.width(), page.height(), BufferedImage.TYPE_INT_RGB), new StripChart(strip));
        }
    }

    /**
     * The text above all panels.
     *
     * @param title   the scene, and the kind of equal work
     * @param finding the winner
     * @param ghost   the description of the ghost
     * @param words   the text beside each run, in the order of {@link #watch}
     */
    public record Head(String title, String finding, String ghost, List<Words> words) {
    }

    /**
     * The text beside a run.
     *
     * @param name    the solver's, with which {@link #watch} was called
     * @param step    its step or tolerance
     * @param cost    the cost of its run
     * @param left    the time at which the run ended early (s)
     */
    public record Words(String name, String step, String cost, OptionalDouble left) {
    }

    /**
     * @param panels   the number of runs besides the reference
     * @param aspect   the width of each panel divided by its height
     * @param rate     the number of frames per second of simulated time (1/s)
     * @param playback the number of frames shown per second (1/s)
     */
    public RaceFilm(int panels, double aspect, double rate, double playback) {
        page = new RacePage(panels, aspect);
        this.rate = rate;
        this.playback = playback;
    }

    /**
     * @param stage the frame settings of the reference's run, in the scene's own colours
     * @return the observer that records the run
     */
    public Observer watchReference(FrameSetup stage) {
        ghost = film(stage, GREY);
        return ghost;
    }

    /**
     * @param name  the name of the solver
     * @param stage the frame settings of its run, in the scene's own colours
     * @return the observer that records the run
     */
    public Observer watch(String name, FrameSetup stage) {
        PanelFilm film = film(stage, SolverStyle.orGrey(name).rgb());
        films.add(film);
        return film;
    }

    private PanelFilm film(FrameSetup stage, int colour) {
        FrameSetup coloured = new FrameSetup(stage.camera(), stage.look().inOneColour(colour), stage.scenery(), "", "");
        return new PanelFilm(coloured, page.getPanelWidth(), page.getPanelHeight(), rate);
    }

    /**
     * Writes {@code animation.gif} and a still of 16:9 of the end.
     *
     * @param writer   writes the sheet, and has the output folder
     * @param sheet    the name of the sheet, such as {@code race.png}
     * @param head     the text at the top
     * @param strip    the data of the chart, with a line of each run's name
     * @param progress receives the progress
     */
    public void write(ChartWriter writer, String sheet, Head head, ChartData strip, DoubleConsumer progress) {
        close();
        int last = ghost.count() - 1;
        try (GifAnimation gif = new GifAnimation(writer.folder(), page.width(), page.height(), importantColours(),
                page.width(), playback);
                Pipeline<Canvas> pipeline = new Pipeline<>(Pipeline.threads(BYTES_PER_PIXEL * page.width()
                        * page.height()), () -> new Canvas(page, strip))) {
            for (int k = 0; k <= last; k++) {
                int index = k;
                pipeline.add(canvas -> {
                    page.draw(canvas.image, head, index / rate, panels(index), canvas.chart);
                    Runnable rest = gif.prepare(index, pixels(canvas.image));
                    return () -> {
                        rest.run();
                        progress.accept((index + 1.0) / ghost.count());
                    };
                });
            }
        }
        RaceSheet.write(writer, sheet, head, panels(last), new StripChart(strip), last / rate);
    }

    /** @return each run's picture, over the ghost */
    private List<BufferedImage> panels(int index) {
        int[] shape = new int[page.getPanelWidth() * page.getPanelHeight()];
        ghost.get(index, shape);
        List<BufferedImage> panels = new ArrayList<>();
        for (PanelFilm film : films) {
            BufferedImage panel = new BufferedImage(page.getPanelWidth(), page.getPanelHeight(),
                    BufferedImage.TYPE_INT_RGB);
            int[] rgb = pixels(panel);
            film.get(index, rgb);
            GhostLayer.add(rgb, shape, ghost.getBackdrop());
            panels.add(panel);
        }
        return panels;
    }

    private static int[] pixels(BufferedImage image) {
        return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    }

    private int[] importantColours() {
        IntStream all = Arrays.stream(ghost.importantColours());
        for (PanelFilm film : films) {
            all = IntStream.concat(all, Arrays.stream(film.importantColours()));
        }
        return all.distinct().toArray();
    }

    /** Ends the drawing threads. */
    @Override
    public void close() {
        if (ghost != null) {                            // before the reference's run there is nothing to end
            ghost.close();
        }
        films.forEach(PanelFilm::close);
    }
}
