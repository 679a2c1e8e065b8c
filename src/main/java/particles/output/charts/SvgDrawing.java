package particles.output.charts;

import java.awt.Dimension;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.apache.batik.svggen.DefaultExtensionHandler;
import org.apache.batik.svggen.ImageHandlerBase64Encoder;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.w3c.dom.DOMImplementation;
import org.w3c.dom.Element;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;

/** A drawing as a vector graphic; its text is text, so that it can be searched and edited. */
final class SvgDrawing {
    /** Batik's own writers of pictures are in a library of their own. */
    private static final class OurImages extends ImageHandlerBase64Encoder {
        @Override
        public void encodeImage(RenderedImage image, OutputStream out) throws SVGGraphics2DIOException {
            try {
                ImageIO.write(image, "png", out);
            } catch (IOException e) {
                throw new SVGGraphics2DIOException(e.getMessage(), e);
            }
        }
    }

    private SvgDrawing() {
    }

    static void write(OutputFolder folder, String name, ChartPage page) {
        try (StringWriter text = new StringWriter()) {
            DOMImplementation dom = DocumentBuilderFactory.newInstance().newDocumentBuilder().getDOMImplementation();
            SVGGraphics2D g = new SVGGraphics2D(dom.createDocument("http://www.w3.org/2000/svg", "svg", null),
                    new OurImages(), new DefaultExtensionHandler(), false);
            g.setSVGCanvasSize(new Dimension(page.width(), page.height()));
            page.drawing().accept(g);
            Element root = g.getRoot();
            root.setAttribute("viewBox", "0 0 " + page.width() + " " + page.height());
            g.stream(root, text, true, false);
            // without the document type, which names an address that some programs would wait for
            folder.write(name, text.toString().replaceFirst("<!DOCTYPE[^>]*>", ""));
        } catch (IOException | ParserConfigurationException e) {
            throw new OutputException(folder.getPath().resolve(name), "write", new IOException(e));
        }
    }
}
