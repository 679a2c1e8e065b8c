package particles.output.animation;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/** Makes pictures smaller by a whole number: each pixel is the mean of a square of them. */
public final class Shrinker {
    final int width;
    final int height;
    private final int fullWidth;
    private final int factor;

    Shrinker(int fullWidth, int fullHeight, int factor) {
        this.fullWidth = fullWidth;
        this.factor = Math.min(factor, Math.min(fullWidth, fullHeight));
        width = fullWidth / this.factor;
        height = fullHeight / this.factor;
    }

    /**
     * Makes a file's picture smaller.
     *
     * @param picture a PNG file
     * @param factor  by how much
     * @return the smaller picture as a JPEG file, a quarter of the size of a PNG file
     * @throws IOException if it cannot be read
     */
    public static byte[] jpeg(Path picture, int factor) throws IOException {
        BufferedImage image = ImageIO.read(picture.toFile());
        int width = image.getWidth();
        Shrinker shrinker = new Shrinker(width, image.getHeight(), factor);
        BufferedImage small = new BufferedImage(shrinker.width, shrinker.height, BufferedImage.TYPE_INT_RGB);
        small.setRGB(0, 0, shrinker.width, shrinker.height, shrinker.shrink(image.getRGB(0, 0, width,
                image.getHeight(), null, 0, width)), 0, shrinker.width);
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(small, "jpg", file);
        return file.toByteArray();
    }

    /**
     * @param rgb the picture, 0xRRGGBB; columns and rows beyond a multiple of the factor are left out
     * @return the smaller one
     */
    int[] shrink(int[] rgb) {
        int[] small = new int[width * height];
        int n = factor * factor;
        for (int p = 0; p < small.length; p++) {
            int first = factor * (p / width * fullWidth + p % width);
            for (int shift = 0; shift < 24; shift += 8) {
                int sum = n / 2;
                for (int row = first; row < first + factor * fullWidth; row += fullWidth) {
                    for (int q = row; q < row + factor; q++) {
                        sum += rgb[q] >> shift & 255;
                    }
                }
                small[p] |= sum / n << shift;
            }
        }
        return small;
    }
}
