package particles.output.animation;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** The colours of a GIF, which ImageIO chooses for a few pictures, and the nearest one to each other colour. */
final class Palette {
    /** Colours whose leading bits agree have the same nearest one. */
    private static final int BITS = 6;
    private static final int SHIFT = 8 - BITS;
    private static final int LEADING = (1 << BITS) - 1;
    /** A colour is in the palette if one is as near as this in red, green and blue; some pixels may have another. */
    private static final int NEAR = 30;
    private static final double STRANGERS = 0.001;

    private final IndexColorModel model;
    private final int[] colours;
    private final short[] nearest = new short[1 << 3 * BITS];

    private Palette(IndexColorModel model) {
        this.model = model;
        colours = new int[model.getMapSize()];
        model.getRGBs(colours);
        Arrays.fill(nearest, (short) -1);
    }

    /** @param pictures the pixels, 0xRRGGBB, of pictures as wide as this; each lends as many, spread all over it */
    static Palette of(List<int[]> pictures, int width) throws IOException {
        int size = pictures.get(0).length;
        BufferedImage mosaic = new BufferedImage(width, size / width, BufferedImage.TYPE_INT_ARGB);
        for (int p = 1; p < size; p++) {                // the first one is transparent
            mosaic.setRGB(p % width, p / width, 0xff000000 | pictures.get(p % pictures.size())[p]);
        }
        ByteArrayOutputStream gif = new ByteArrayOutputStream();
        // in memory: ImageIO's own streams make a file, and register it for the end of Java, where a stopped run ends
        ImageIO.write(mosaic, "gif", new MemoryCacheImageOutputStream(gif));
        return new Palette((IndexColorModel) ImageIO.read(new MemoryCacheImageInputStream(
                new ByteArrayInputStream(gif.toByteArray()))).getColorModel());
    }

    /** @return the largest difference in red, green or blue */
    static int distance(int one, int other) {
        int red = Math.abs((one >> 16 & 255) - (other >> 16 & 255));
        int green = Math.abs((one >> 8 & 255) - (other >> 8 & 255));
        return Math.max(red, Math.max(green, Math.abs((one & 255) - (other & 255))));
    }

    /** @return whether nearly all these pixels have a colour like theirs here */
    boolean fits(int[] rgb, int[] pixels) {
        return Arrays.stream(pixels).filter(p -> distance(colours[index(rgb[p])], rgb[p]) > NEAR).count()
                <= STRANGERS * rgb.length;
    }

    /** @return a picture that is transparent all over */
    BufferedImage picture(int width, int height) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, model);
        Arrays.fill(((DataBufferByte) picture.getRaster().getDataBuffer()).getData(), (byte) transparent());
        return picture;
    }

    /** Sets a pixel to the nearest colour. */
    void set(BufferedImage picture, int x, int y, int rgb) {
        picture.getRaster().setSample(x, y, 0, index(rgb));
    }

    /** @return the index of the transparent colour */
    int transparent() {
        return model.getTransparentPixel();
    }

    private int index(int rgb) {
        int red = rgb >> 16 + SHIFT & LEADING;
        int cell = red << 2 * BITS | (rgb >> 8 + SHIFT & LEADING) << BITS | rgb >> SHIFT & LEADING;
        if (nearest[cell] < 0) {
            int best = transparent() == 0 ? 1 : 0;
            for (int k = 0; k < colours.length; k++) {
                if (k != transparent() && difference(colours[k], rgb) < difference(colours[best], rgb)) {
                    best = k;
                }
            }
            nearest[cell] = (short) best;
        }
        return nearest[cell];
    }

    /** The difference as eyes see it: they see green best and blue worst. */
    private static int difference(int one, int other) {
        int red = (one >> 16 & 255) - (other >> 16 & 255);
        int green = (one >> 8 & 255) - (other >> 8 & 255);
        int blue = (one & 255) - (other & 255);
        return 3 * red * red + 4 * green * green + 2 * blue * blue;
    }
}
