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
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.files.PngEncoder;
import particles.output.text.FontCheck;
import particles.view.ChartData;
import particles.view.VectorField;

/**
 * Writes charts as PNG pictures, and as SVG if wanted, all in one style.
 *
 * @param folder the output folder
 * @param format the format of the pictures
 */
public record ChartWriter(OutputFolder folder, ChartFormat format) {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 560;
    private static final int STACKED_HEIGHT = 760;
    private static final int SQUARE_WIDTH = 720;
    private static final int SQUARE_HEIGHT = 700;
    /** The ending of a picture's name. */
    public static final String PNG = ".png";
    /** The ending of a vector graphic's name. */
    public static final String SVG = ".svg";

    /**
     * Writes charts above each other over the same x axis, or on slides each by itself.
     *
     * @param name   the file's name, such as {@code energy.png}; further slides are {@code energy-2.png} and so on
     * @param charts the charts, at least one, the uppermost first
     * @throws OutputException if a file cannot be written, or this machine has no font
     */
    public void write(String name, List<ChartData> charts) {
        Panel whole = new Panel(charts, Panel.Kind.CHART, Optional.empty());
        List<Panel> pages = format.slide() ? whole.apart() : List.of(whole);
        for (int k = 0; k < pages.size(); k++) {
            write(k == 0 ? name : name.replace(PNG, "-" + (k + 1) + PNG), pages.get(k));
        }
    }

    /**
     * A path in state space.
     *
     * @param name  the file's name, such as {@code phase.png}
     * @param data  position against velocity: the path, then points to be marked, such as its start
     * @param field the arrows behind it, if there are any
     * @throws OutputException if a file cannot be written, or this machine has no font
     */
    public void writePhase(String name, ChartData data, Optional<VectorField> field) {
        write(name, Panel.phase(data, field));
    }

    /**
     * @param name  the file's name, such as {@code work-precision.png}
     * @param panel the chart
     * @throws OutputException if a file cannot be written, or this machine has no font
     */
    public void write(String name, Panel panel) {
        FontCheck.require(folder.getPath().resolve(name));
        FittedChart chart = Charts.of(panel);
        List<ChartData> charts = panel.charts();
        int rows = charts.stream().mapToInt(data -> data.rows().size()).max().orElse(0);
        long ofQuantities = charts.stream().filter(data -> data.rows().isEmpty()).count();
        int width = format.width(chart.hasEqualUnits() ? SQUARE_WIDTH : WIDTH);
        int height = format.height(chart.hasEqualUnits() ? SQUARE_HEIGHT
                : (ofQuantities > 1 ? STACKED_HEIGHT : HEIGHT) + (rows == 0 ? 0 : Charts.ROW * (rows + 2)));
        write(name, width, height, g -> chart.draw(g, new Rectangle2D.Double(0, 0, width, height)));
    }

    /**
     * @param name    the file's name
     * @param width   the width of the page, in pixels of the layout
     * @param height  the height of the page
     * @param drawing draws the page
     * @throws OutputException if a file cannot be written
     */
    public void write(String name, int width, int height, Consumer<Graphics2D> drawing) {
        int scale = format.scale();
        BufferedImage image = new BufferedImage(scale * width, scale * height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
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
        if (format.svg()) {
            SvgDrawing.write(folder, name.replace(PNG, SVG), width, height, drawing);
        }
    }
}
