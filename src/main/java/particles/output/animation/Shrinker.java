package particles.output.animation;

/** Makes pictures smaller by a whole number: each pixel is the mean of a square of them. */
final class Shrinker {
    /** One in each of three sums of 20 bits, which share a long. */
    private static final long ONES = 1L << 40 | 1L << 20 | 1L;
    /** So that 20 bits hold a sum. */
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
        int n = factor * factor;
        for (int y = 0, p = 0; y < height; y++) {
            for (int x = 0; x < width; x++, p++) {
                long sum = n / 2 * ONES;
                int row = factor * (y * fullWidth + x);
                for (int dy = 0; dy < factor; dy++, row += fullWidth) {
                    for (int q = row; q < row + factor; q++) {
                        int c = rgb[q];
                        sum += (c & 0xff0000L) << 24 | (c & 0xff00L) << 12 | c & 0xffL;
                    }
                }
                small[p] = (int) (sum >> 40) / n << 16 | (int) (sum >> 20 & 0xfffff) / n << 8 | (int) (sum & 0xfffff)
                        / n;
            }
        }
    }
}
