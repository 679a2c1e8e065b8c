package particles.output.race;

/**
 * Adds a translucent ghost to a picture, behind everything that moves: in the pixels where the ghost's own picture
 * differs from the empty backdrop and the picture does not.
 */
final class GhostLayer {
    private static final int OPACITY = 150;         // of 256
    /** A pixel this far from the backdrop, in steps of 1/256, is covered; a shadow is not. */
    private static final int COVERED = 96;

    private GhostLayer() {
    }

    /**
     * @param rgb      the picture; the ghost is added to it
     * @param ghost    the ghost's picture, of the same size
     * @param backdrop the same without anything that moves
     */
    static void add(int[] rgb, int[] ghost, int[] backdrop) {
        for (int p = 0; p < rgb.length; p++) {
            int empty = backdrop[p];
            int shape = ghost[p];
            if (shape == empty) {
                continue;
            }
            int free = COVERED - Math.min(COVERED, difference(rgb[p], empty));
            int weight = OPACITY * free / COVERED;
            rgb[p] = channel(rgb[p], shape, empty, 16, weight) | channel(rgb[p], shape, empty, 8, weight)
                    | channel(rgb[p], shape, empty, 0, weight);
        }
    }

    private static int difference(int a, int b) {
        return Math.max(Math.abs((a >> 16 & 255) - (b >> 16 & 255)),
                Math.max(Math.abs((a >> 8 & 255) - (b >> 8 & 255)), Math.abs((a & 255) - (b & 255))));
    }

    private static int channel(int rgb, int ghost, int empty, int shift, int weight) {
        int value = (rgb >> shift & 255) + weight * ((ghost >> shift & 255) - (empty >> shift & 255)) / 256;
        return Math.max(0, Math.min(255, value)) << shift;
    }
}
