package particles.output.files;

import ar.com.hjg.pngj.FilterType;
import ar.com.hjg.pngj.ImageInfo;
import ar.com.hjg.pngj.ImageLineByte;
import ar.com.hjg.pngj.PngWriter;
import java.io.ByteArrayOutputStream;
import java.util.zip.Deflater;

/**
 * Fast encoder of 8-bit RGB pictures as PNG: filters chosen from a sample of rows, fast compression. ImageIO's writer
 * takes several times as long for a frame.
 */
public final class PngEncoder {
    private PngEncoder() {
    }

    /**
     * @param width  the width of a picture (pixels)
     * @param height its height
     * @param rgb    the pixels, 0xRRGGBB, row by row from the top
     * @return the whole file
     */
    public static byte[] file(int width, int height, int[] rgb) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        PngWriter writer = new PngWriter(file, new ImageInfo(width, height, 8, false));
        writer.setCompLevel(Deflater.BEST_SPEED);
        writer.setFilterType(FilterType.FILTER_ADAPTIVE_FAST);
        ImageLineByte row = new ImageLineByte(writer.imgInfo);
        byte[] line = row.getScanline();
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int pixel = rgb[y * width + x];
                line[3 * x] = (byte) (pixel >> 16);
                line[3 * x + 1] = (byte) (pixel >> 8);
                line[3 * x + 2] = (byte) pixel;
            }
            writer.writeRow(row);
        }
        writer.end();
        return file.toByteArray();
    }
}
