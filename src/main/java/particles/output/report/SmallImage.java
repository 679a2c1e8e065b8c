package particles.output.report;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.ImageIO;

/**
 * Reduces the size of a chart's picture, for a page that holds many: so few shades of each primary colour are enough
 * for lines and letters that there are 256 colours at most, and a pixel is a byte.
 */
final class SmallImage {
    private static final int MOST_COLOURS = 256;
    private static final int MOST_SHADES = 16;

    private SmallImage() {
    }

    /**
     * @param png a picture as a PNG file
     * @return the picture with fewer shades if that is smaller; otherwise the same file
     * @throws IOException if it is no picture
     */
    static byte[] of(byte[] png) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
        if (image == null) {
            throw new IOException("not a picture that can be read");
        }
        int width = image.getWidth();
        int[] given = image.getRGB(0, 0, width, image.getHeight(), null, 0, width);
        int[] rgb;
        int[] palette;
        int shades = MOST_SHADES;
        do {
            int steps = shades - 1;
            rgb = Arrays.stream(given).map(colour -> shade(colour >> 16, steps) << 16 | shade(colour >> 8, steps) << 8
                    | shade(colour, steps)).toArray();
            palette = Arrays.stream(rgb).distinct().sorted().toArray();
            shades--;
        } while (palette.length > MOST_COLOURS);
        byte[] pixels = new byte[rgb.length];
        for (int k = 0; k < rgb.length; k++) {
            pixels[k] = (byte) Arrays.binarySearch(palette, rgb[k]);
        }
        BufferedImage small = new BufferedImage(width, image.getHeight(), BufferedImage.TYPE_BYTE_INDEXED,
                new IndexColorModel(8, palette.length, palette, 0, false, -1, DataBuffer.TYPE_BYTE));
        small.getRaster().setDataElements(0, 0, width, image.getHeight(), pixels);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(small, "png", file);
        return file.size() < png.length ? file.toByteArray() : png;
    }

    /** White stays white, and black black. */
    private static int shade(int value, int steps) {
        return Math.round((value & 255) * steps / 255f) * 255 / steps;
    }
}
