package particles.output.charts;

import com.lowagie.text.Document;
import com.lowagie.text.FontFactory;
import com.lowagie.text.Rectangle;
import com.lowagie.text.pdf.BaseFont;
import com.lowagie.text.pdf.DefaultFontMapper;
import com.lowagie.text.pdf.FontMapper;
import com.lowagie.text.pdf.PdfGraphics2D;
import com.lowagie.text.pdf.PdfWriter;
import java.awt.Font;
import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.stream.Stream;

/**
 * All slides of a task as one PDF file: vectors, and text that can be searched if the font is found. Otherwise letters
 * are outlines, since the fonts of every PDF reader lack a minus sign.
 */
final class SlidesPdf {
    private SlidesPdf() {
    }

    static byte[] of(List<ChartPage> pages) {
        FontFactory.registerDirectories();
        boolean found = Stream.of(ChartStyle.TITLE, ChartStyle.LABEL)
                .allMatch(font -> FontFactory.isRegistered(font.getFontName()));
        FontMapper fonts = new DefaultFontMapper() {
            @Override
            public BaseFont awtToPdf(Font font) {
                return FontFactory.getFont(font.getFontName(), BaseFont.IDENTITY_H, BaseFont.EMBEDDED).getBaseFont();
            }
        };
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        Rectangle size = new Rectangle(ChartFormat.SLIDE_WIDTH, ChartFormat.SLIDE_HEIGHT);
        Document document = new Document(size);
        PdfWriter writer = PdfWriter.getInstance(document, file);
        document.open();
        for (ChartPage page : pages) {
            document.newPage();                         // does nothing on the first page, which is still empty
            PdfGraphics2D g = new PdfGraphics2D(writer.getDirectContent(), size.getWidth(), size.getHeight(),
                    fonts, !found, false, 0);
            double scale = size.getWidth() / page.width();
            g.scale(scale, scale);
            page.drawing().accept(g);
            g.dispose();
        }
        document.close();
        return file.toByteArray();
    }
}
