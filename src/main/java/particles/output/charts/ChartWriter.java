package particles.output.charts;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.ArrayList;
import java.util.List;
import particles.output.files.FontCheck;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.files.PngEncoder;

/** Writes charts as PNG pictures, and as SVG if wanted, all in one style; slides at the end once more as one PDF. */
public final class ChartWriter implements AutoCloseable {
    /** The ending of a picture's name. */
    public static final String PNG = ".png";
    /** The ending of a vector graphic's name. */
    public static final String SVG = ".svg";
    /** The file with all slides. */
    public static final String PDF = "slides.pdf";

    private final OutputFolder folder;
    private final ChartFormat format;
    private final List<ChartPage> slides = new ArrayList<>();

    /**
     * @param folder the output folder
     * @param format the format of the pictures
     */
    public ChartWriter(OutputFolder folder, ChartFormat format) {
        this.folder = folder;
        this.format = format;
    }

    /**
     * @param name the file's name, such as {@code work-precision.png}
     * @param page the page
     * @throws OutputException if a file cannot be written, or this machine has no font
     */
    public void write(String name, ChartPage page) {
        if (!FontCheck.isAvailable()) {
            throw new OutputException(folder.getPath().resolve(name), "draw", FontCheck.NO_FONT, null);
        }
        int scale = format.scale();
        BufferedImage image = new BufferedImage(scale * page.width(), scale * page.height(),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
        page.drawing().accept(g);
        g.dispose();
        int[] pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        folder.write(name, PngEncoder.file(image.getWidth(), image.getHeight(), pixels));
        if (format.svg()) {
            SvgDrawing.write(folder, name.replace(PNG, SVG), page);
        }
        if (format.slide()) {
            slides.add(page);
        }
    }

    /** Writes the PDF if there are slides. */
    @Override
    public void close() {
        if (!slides.isEmpty()) {
            folder.write(PDF, SlidesPdf.of(slides));
        }
    }
}
