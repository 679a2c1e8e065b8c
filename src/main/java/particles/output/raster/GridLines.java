package particles.output.raster;

/** Antialiased grid lines at whole numbers, every fifth one thicker: the mean coverage over a pixel's width. */
final class GridLines {
    private static final double THIN = 0.016;
    private static final double THICK = 0.034;

    private GridLines() {
    }

    /**
     * @param u    the pixel's position in units of the grid
     * @param foot the pixel's width in those units
     * @return the covered fraction, 0 to 1; thin lines count less
     */
    static double coverage(double u, double foot) {
        double f = Math.max(foot, 1e-9);
        double thin = mean(u, f, THIN);
        double thick = mean(u / 5, f / 5, THICK / 5);
        return Math.min(1, Math.max(0.75 * thin, thick));
    }

    private static double mean(double u, double foot, double line) {
        return (integral(u + foot / 2, line) - integral(u - foot / 2, line)) / foot;
    }

    /** The integral from 0 to u of the function that is 1 on lines of this width around whole numbers, else 0. */
    private static double integral(double u, double line) {
        double cell = Math.floor(u + 0.5);
        return cell * line + Math.max(-line / 2, Math.min(line / 2, u - cell));
    }
}
