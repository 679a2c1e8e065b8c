package particles.output.charts;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jfree.chart.JFreeChart;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.files.PngEncoder;
import particles.output.text.FontCheck;
import particles.view.ChartData;
import particles.view.VectorField;

/** Writes chart data as PNG pictures, all in one style. */
public final class ChartWriter {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 560;
    private static final int STACKED_HEIGHT = 760;
    /** Device pixels for each pixel of the layout, so that print and large screens get sharp lines. */
    private static final int SCALE = 2;
    /** How wide the picture of a chart is. */
    public static final int PIXELS_WIDE = SCALE * WIDTH;

    private ChartWriter() {
    }

    /**
     * @param folder where the picture goes
     * @param name   the file's name, such as {@code work-precision.png}
     * @param data   what it shows
     * @throws OutputException if it cannot be written, or this machine has no font
     */
    public static void write(OutputFolder folder, String name, ChartData data) {
        FontCheck.require(folder.getPath().resolve(name));
        write(folder, name, Charts.of(data), HEIGHT);
    }

    /**
     * Charts above each other over the same x axis; the title is the first one's.
     *
     * @param folder where the picture goes
     * @param name   the file's name, such as {@code energy.png}
     * @param data   at least one chart, the uppermost first
     * @throws OutputException if it cannot be written, or this machine has no font
     */
    public static void writeStacked(OutputFolder folder, String name, List<ChartData> data) {
        FontCheck.require(folder.getPath().resolve(name));
        int rows = data.stream().mapToInt(chart -> chart.rows().size()).max().orElse(0);
        long ofQuantities = data.stream().filter(chart -> chart.rows().isEmpty()).count();
        write(folder, name, Charts.stacked(data), (ofQuantities > 1 ? STACKED_HEIGHT : HEIGHT)
                + (rows == 0 ? 0 : Charts.ROW * (rows + 2)));
    }

    /**
     * A path in state space.
     *
     * @param folder where the picture goes
     * @param name   the file's name, such as {@code phase.png}
     * @param data   position against velocity: the path, then points to be marked, such as its start
     * @param field  the arrows behind it, if there are any
     * @throws OutputException if it cannot be written, or this machine has no font
     */
    public static void writePhase(OutputFolder folder, String name, ChartData data, Optional<VectorField> field) {
        FontCheck.require(folder.getPath().resolve(name));
        write(folder, name, PhasePlot.of(data, field), HEIGHT + 100);
    }

    /**
     * A map of a plane: a unit along x is as long as one along y, so that circles are round.
     *
     * @param folder where the picture goes
     * @param name   the file's name, such as {@code region.png}
     * @param data   what it shows
     * @throws OutputException if it cannot be written, or this machine has no font
     */
    public static void writeMap(OutputFolder folder, String name, ChartData data) {
        FontCheck.require(folder.getPath().resolve(name));
        write(folder, name, Charts.map(data, WIDTH, STACKED_HEIGHT), STACKED_HEIGHT);
    }

    private static void write(OutputFolder folder, String name, JFreeChart chart, int height) {
        chart.setTextAntiAlias(true);
        write(folder, name, WIDTH, height, g -> chart.draw(g, new Rectangle2D.Double(0, 0, WIDTH, height)));
    }

    /** @param drawing draws on a page of this size */
    public static void write(OutputFolder folder, String name, int width, int height, Consumer<Graphics2D> drawing) {
        BufferedImage image = new BufferedImage(SCALE * width, SCALE * height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(SCALE, SCALE);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        drawing.accept(g);
        g.dispose();
        PngEncoder encoder = new PngEncoder(image.getWidth(), image.getHeight());
        try (OutputFile file = folder.create(name)) {
            encoder.write(((DataBufferInt) image.getRaster().getDataBuffer()).getData(), file);
            file.commit();
        } catch (IOException e) {
            throw new OutputException(folder.getPath().resolve(name), "write", e);
        } finally {
            encoder.close();
        }
    }
}
