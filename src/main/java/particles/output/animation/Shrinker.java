package particles.output.animation;

import java.util.Arrays;

/** Makes pictures smaller by a whole number: each pixel is the mean of a square of them. */
final class Shrinker {
    /** So that 16 bits hold the sum of a column. */
    private static final int LARGEST = 64;

    final int width;
    final int height;
    private final int fullWidth;
    private final int factor;

    Shrinker(int fullWidth, int fullHeight, int factor) {
        this.fullWidth = fullWidth;
        this.factor = Math.min(factor, Math.min(LARGEST, Math.min(fullWidth, fullHeight)));
        width = fullWidth / this.factor;
        height = fullHeight / this.factor;
    }

    /**
     * @param rgb   the picture, 0xRRGGBB; columns and rows beyond a multiple of the factor are left out
     * @param small receives the smaller one
     */
    void shrink(int[] rgb, int[] small) {
        if (factor == 1) {
            System.arraycopy(rgb, 0, small, 0, small.length);
            return;
        }
        int[] redBlue = new int[fullWidth];
        int[] green = new int[fullWidth];
        for (int y = 0; y < height; y++) {
            Arrays.fill(redBlue, 0);
            Arrays.fill(green, 0);
            for (int row = factor * y; row < factor * (y + 1); row++) {
                addRow(rgb, row * fullWidth, redBlue, green);
            }
            for (int x = 0; x < width; x++) {
                small[y * width + x] = factor == 2 ? meanOfTwo(redBlue, green, 2 * x)
                        : mean(redBlue, green, factor * x);
            }
        }
    }

    /** A loop of its own, so short that it runs on vectors. */
    private static void addRow(int[] rgb, int from, int[] redBlue, int[] green) {
        for (int x = 0; x < redBlue.length; x++) {
            redBlue[x] += rgb[from + x] & 0xff00ff;
            green[x] += rgb[from + x] >> 8 & 0xff;
        }
    }

    private int mean(int[] redBlue, int[] green, int from) {
        int half = factor * factor / 2;
        int r = half;
        int g = half;
        int b = half;
        for (int q = from; q < from + factor; q++) {
            r += redBlue[q] >>> 16;
            g += green[q];
            b += redBlue[q] & 0xffff;
        }
        int n = factor * factor;
        return r / n << 16 | g / n << 8 | b / n;
    }

    /** The same for the usual factor, in less than half the time. */
    private static int meanOfTwo(int[] redBlue, int[] green, int from) {
        return redBlue[from] + redBlue[from + 1] + 0x020002 >> 2 & 0xff00ff
                | green[from] + green[from + 1] + 2 >> 2 << 8;
    }
}
