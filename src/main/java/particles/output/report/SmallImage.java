package particles.output.report;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;

/**
 * Reduces the size of a chart's picture, for a page that holds many. 16 shades of each primary colour are enough for
 * lines and letters; of these the 256 most frequent colours are kept, so that a pixel is a byte.
 */
final class SmallImage {
    private static final int MOST_COLOURS = 256;
    private static final int SHADES = 16;

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
        int[] rgb = image.getRGB(0, 0, width, image.getHeight(), null, 0, width);
        Map<Integer, Integer> counts = new HashMap<>();
        for (int k = 0; k < rgb.length; k++) {
            rgb[k] = shade(rgb[k] >> 16) << 16 | shade(rgb[k] >> 8) << 8 | shade(rgb[k]);
            counts.merge(rgb[k], 1, Integer::sum);
        }
        List<Integer> order = counts.keySet().stream().sorted(Comparator.comparing((Integer colour) ->
                -counts.get(colour)).thenComparing(colour -> colour)).limit(MOST_COLOURS).toList();
        Map<Integer, Integer> colours = new HashMap<>();
        counts.keySet().forEach(colour -> colours.put(colour, nearest(colour, order)));
        int[] palette = order.stream().mapToInt(Integer::intValue).toArray();
        BufferedImage small = new BufferedImage(width, image.getHeight(), BufferedImage.TYPE_BYTE_INDEXED,
                new IndexColorModel(8, palette.length, palette, 0, false, -1, DataBuffer.TYPE_BYTE));
        byte[] pixels = new byte[rgb.length];
        for (int k = 0; k < rgb.length; k++) {
            pixels[k] = colours.get(rgb[k]).byteValue();
        }
        small.getRaster().setDataElements(0, 0, width, image.getHeight(), pixels);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(small, "png", file);
        return file.size() < png.length ? file.toByteArray() : png;
    }

    private static int nearest(int colour, List<Integer> others) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int c = 0; c < others.size(); c++) {
            int distance = 0;
            for (int shift = 0; shift < 24; shift += 8) {
                int off = (colour >> shift & 255) - (others.get(c) >> shift & 255);
                distance += off * off;
            }
            best = distance < least ? c : best;
            least = Math.min(least, distance);
        }
        return best;
    }

    /** White stays white, and black black. */
    private static int shade(int value) {
        return Math.round((value & 255) * (SHADES - 1) / 255f) * 255 / (SHADES - 1);
    }
}
