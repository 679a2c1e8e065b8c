package particles.output.report;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferInt;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
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
        BufferedImage read = ImageIO.read(new ByteArrayInputStream(png));
        if (read == null) {
            throw new IOException("not a picture that can be read");
        }
        int width = read.getWidth();
        int height = read.getHeight();
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        image.createGraphics().drawImage(read, 0, 0, null);             // getRGB would take longer than all the rest
        int[] given = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        BitSet colours = new BitSet();
        for (int colour : given) {
            colours.set(colour);
        }
        int steps = MOST_SHADES;
        int[] palette;
        do {
            steps--;
            palette = reduced(colours.stream(), steps).distinct().sorted().toArray();
        } while (palette.length > MOST_COLOURS);
        int[] rgb = reduced(Arrays.stream(given), steps).toArray();
        byte[] pixels = new byte[rgb.length];
        for (int k = 0; k < rgb.length; k++) {
            pixels[k] = (byte) Arrays.binarySearch(palette, rgb[k]);
        }
        BufferedImage small = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED,
                new IndexColorModel(8, palette.length, palette, 0, false, -1, DataBuffer.TYPE_BYTE));
        small.getRaster().setDataElements(0, 0, width, height, pixels);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(small, "png", file);
        return file.size() < png.length ? file.toByteArray() : png;
    }

    private static IntStream reduced(IntStream colours, int steps) {
        return colours.map(colour -> shade(colour >> 16, steps) << 16 | shade(colour >> 8, steps) << 8
                | shade(colour, steps));
    }

    /** White stays white, and black black. */
    private static int shade(int value, int steps) {
        return Math.round((value & 255) * steps / 255f) * 255 / steps;
    }
}
