package particles.rules;

/**
 * The first place where a cubic becomes negative, by subdivision of its B&eacute;zier form: a piece whose four coefficients
 * are not negative is nowhere negative, so that nothing is missed, however short the dip. (Method: T. Sederberg, T. Nishita
 * 1990, B&eacute;zier clipping, with halving in place of clipping.)
 */
final class FirstCrossing {
    private static final int DEEPEST = 45;

    private FirstCrossing() {
    }

    /**
     * @param b0 B&eacute;zier coefficients: the value at 0
     * @param b1 the value at 0 plus a third of the slope there
     * @param b2 the value at 1 minus a third of the slope there
     * @param b3 the value at 1
     * @return the u in 0 ... 1 where the cubic first becomes negative, within 2^-45; NaN if it never does
     */
    static double of(double b0, double b1, double b2, double b3) {
        return search(b0, b1, b2, b3, 0, 1, 0);
    }

    private static double search(double b0, double b1, double b2, double b3, double from, double to, int depth) {
        if (b0 >= 0 && b1 >= 0 && b2 >= 0 && b3 >= 0) {
            return Double.NaN;
        }
        if (b0 < 0) {
            return from;
        }
        if (depth == DEEPEST) {
            return b3 < 0 ? from : Double.NaN;
        }
        double b01 = (b0 + b1) / 2;
        double b12 = (b1 + b2) / 2;
        double b23 = (b2 + b3) / 2;
        double b012 = (b01 + b12) / 2;
        double b123 = (b12 + b23) / 2;
        double middle = (b012 + b123) / 2;
        double half = (from + to) / 2;
        double left = search(b0, b01, b012, middle, from, half, depth + 1);
        return Double.isNaN(left) ? search(middle, b123, b23, b3, half, to, depth + 1) : left;
    }
}
