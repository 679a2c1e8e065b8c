package particles.output.animation;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleConsumer;
import java.util.zip.Deflater;
import java.util.zip.DeflaterInputStream;
import java.util.zip.InflaterInputStream;
import particles.Observer;
import particles.output.charts.ChartPage;
import particles.output.charts.StripChart;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.FrameSink;
import particles.output.frames.Pipeline;
import particles.view.Chart;
import particles.view.Look;

/**
 * The film of a race: the runs of several solvers beside each other, each over the translucent ghost of the reference,
 * with a chart over the same time. The runs are recorded one after the other, then the film is written.
 */
public final class RaceFilm implements AutoCloseable {
    /** The grey of the ghost. */
    private static final int GREY = 0x6f747c;
    private static final int OPACITY = 150;         // of 256
    /** A pixel this far from the backdrop, in steps of 1/256, is covered by what moves; a shadow is not. */
    private static final int COVERED = 96;
    /** Pixels of the film for one of the page. */
    static final double SCALE = 4.0 / 3;
    private static final int WIDTH = scaled(RacePage.WIDTH);
    private static final int HEIGHT = scaled(RacePage.HEIGHT);
    /** A page, its panels and its copies for the file. */
    private static final long BYTES_PER_PIXEL = 20;

    private final RacePage page;
    private final double rate;
    private final double playback;
    /** The first one is of the reference. */
    private final List<PanelFilm> films = new ArrayList<>();

    /** What one thread draws on; a chart cannot be drawn by two threads at a time. */
    private record Canvas(BufferedImage image, StripChart chart) {
    }

    /**
     * The text above all panels.
     *
     * @param title   the scene, and the kind of equal work
     * @param ghost   the description of the ghost
     * @param words   the text beside each run, in the order of {@link #watch}
     */
    public record Head(String title, String ghost, List<Words> words) {
    }

    /**
     * The text beside a run.
     *
     * @param name    the solver's
     * @param look    its look in the chart
     * @param answer  the number that stands beside its name
     * @param text    its step or tolerance, and the cost of its run
     * @param left    the time at which the run ended early (s)
     */
    public record Words(String name, Look look, String answer, String text, OptionalDouble left) {
    }

    /**
     * @param panels   the number of runs besides the reference
     * @param aspect   the width of each panel divided by its height
     * @param rate     the number of frames per second of simulated time (1/s)
     * @param playback the number of frames shown per second (1/s)
     */
    public RaceFilm(int panels, double aspect, double rate, double playback) {
        page = RacePage.of(panels, aspect);
        this.rate = rate;
        this.playback = playback;
    }

    /**
     * @param panels the number of runs besides the reference
     * @return the width divided by the height of the panels that have the most room
     */
    public static double aspect(int panels) {
        return RacePage.aspect(panels);
    }

    /**
     * @param solver the look of the solver; none for the reference, whose run is the first
     * @param stage  the frame settings of the run, in the scene's own colours
     * @return the observer that records the run
     */
    public Observer watch(Optional<Look> solver, FrameSetup stage) {
        int colour = solver.map(Look::rgb).orElse(GREY);
        FrameSetup coloured = new FrameSetup(stage.camera(), stage.look().inOneColour(colour), stage.scenery(), "", "");
        PanelFilm film = new PanelFilm(coloured, scaled(page.panelWidth()), scaled(page.panelHeight()), rate);
        films.add(film);
        return film.observer;
    }

    /**
     * Writes {@code animation.gif}.
     *
     * @param folder   the output folder
     * @param head     the text at the top
     * @param strip    the data of the chart, with a line of each run's name
     * @param progress receives the progress
     */
    public void write(OutputFolder folder, Head head, Chart strip, DoubleConsumer progress) {
        close();
        PanelFilm ghost = films.get(0);
        int[] backdrop = ghost.renderer.renderBackdrop();
        try (GifAnimation gif = new GifAnimation(folder, WIDTH, HEIGHT, WIDTH, playback);
                Pipeline<Canvas> pipeline = new Pipeline<>(Pipeline.threads(BYTES_PER_PIXEL * WIDTH * HEIGHT), () ->
                        new Canvas(new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB),
                                new StripChart(strip)))) {
            for (int k = 0; k < ghost.packed.size(); k++) {
                int index = k;
                pipeline.add(canvas -> {
                    Graphics2D g = canvas.image.createGraphics();
                    g.scale(SCALE, SCALE);
                    page.draw(g, head, index / rate, panels(index, backdrop), canvas.chart);
                    g.dispose();
                    Runnable rest = gif.prepare(index, pixels(canvas.image));
                    return () -> {
                        rest.run();
                        progress.accept((index + 1.0) / ghost.packed.size());
                    };
                });
            }
        }
    }

    /**
     * @param head  the text at the top
     * @param strip the data of the chart
     * @return a page with the end of the film, to be drawn when that is written
     */
    public ChartPage sheet(Head head, Chart strip) {
        PanelFilm ghost = films.get(0);
        int last = ghost.packed.size() - 1;
        List<BufferedImage> panels = panels(last, ghost.renderer.renderBackdrop());
        return new ChartPage(RacePage.WIDTH, RacePage.HEIGHT, g ->
                page.draw(g, head, last / rate, panels, new StripChart(strip)));
    }

    /** @return each run's picture, over the ghost */
    private List<BufferedImage> panels(int index, int[] backdrop) {
        int[] shape = new int[backdrop.length];
        films.get(0).get(index, shape);
        List<BufferedImage> panels = new ArrayList<>();
        for (PanelFilm film : films.subList(1, films.size())) {
            BufferedImage panel = new BufferedImage(scaled(page.panelWidth()), scaled(page.panelHeight()),
                    BufferedImage.TYPE_INT_RGB);
            film.get(index, pixels(panel));
            addGhost(pixels(panel), shape, backdrop);
            panels.add(panel);
        }
        return panels;
    }

    /**
     * Adds a translucent ghost to a picture, behind everything that moves: in the pixels where the ghost's own picture
     * differs from the empty backdrop and the picture does not.
     *
     * @param rgb      the picture; the ghost is added to it
     * @param ghost    the ghost's picture, of the same size
     * @param backdrop the same without anything that moves
     */
    static void addGhost(int[] rgb, int[] ghost, int[] backdrop) {
        for (int p = 0; p < rgb.length; p++) {
            if (ghost[p] != backdrop[p]) {
                rgb[p] = withGhost(rgb[p], ghost[p], backdrop[p]);
            }
        }
    }

    private static int withGhost(int rgb, int ghost, int empty) {
        int difference = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            difference = Math.max(difference, Math.abs((rgb >> shift & 255) - (empty >> shift & 255)));
        }
        int weight = OPACITY * Math.max(0, COVERED - difference) / COVERED;
        int mixed = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            int value = (rgb >> shift & 255) + weight * ((ghost >> shift & 255) - (empty >> shift & 255)) / 256;
            mixed |= Math.max(0, Math.min(255, value)) << shift;
        }
        return mixed;
    }

    /** @return a length of the page in pixels of the film */
    static int scaled(int length) {
        return (int) Math.round(SCALE * length);
    }

    private static int[] pixels(BufferedImage image) {
        return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    }

    /** Ends the drawing threads. */
    @Override
    public void close() {
        films.forEach(film -> film.observer.close());
    }

    /** The frames of one run, compressed in memory until those of all other runs are there too. */
    static final class PanelFilm implements FrameSink {
        final FrameRenderer renderer;
        /** Draws the run; closed, it waits for the frames of a run that ended early. */
        final FrameObserver observer;
        final List<byte[]> packed = new ArrayList<>();

        /**
         * @param stage  the settings of the frames
         * @param width  the width of the frames (pixels)
         * @param height the height of the frames (pixels)
         * @param rate   the number of frames per second of simulated time (1/s)
         */
        PanelFilm(FrameSetup stage, int width, int height, double rate) {
            renderer = new FrameRenderer(stage, width, height, Optional.empty());
            observer = new FrameObserver(renderer, rate, List.of(this));
        }

        /**
         * @param index the index of a frame; after the last frame, the last one counts
         * @param rgb   receives its pixels
         */
        void get(int index, int[] rgb) {
            byte[] frame = packed.get(Math.min(index, packed.size() - 1));
            try (InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(frame))) {
                ByteBuffer.wrap(in.readAllBytes()).asIntBuffer().get(rgb);
            } catch (IOException e) {
                throw new UncheckedIOException("a frame that was packed here cannot be unpacked", e);
            }
        }

        /** The frames are read when the drawing threads have ended. */
        @Override
        public Runnable prepare(int index, int[] rgb) {
            ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * rgb.length);
            bytes.asIntBuffer().put(rgb);
            Deflater fast = new Deflater(Deflater.BEST_SPEED);
            try (InputStream in = new DeflaterInputStream(new ByteArrayInputStream(bytes.array()), fast)) {
                byte[] frame = in.readAllBytes();
                return () -> packed.add(frame);
            } catch (IOException e) {
                throw new UncheckedIOException("memory gives all that was written", e);
            } finally {
                fast.end();
            }
        }
    }
}
