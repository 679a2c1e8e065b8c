package deSolvers.linear;

/** Arithmetic of 3 x 3 blocks that lie by rows in longer arrays. */
final class Block3 {
    /** A block whose determinant is smaller than this part of its largest entry cubed counts as singular. */
    private static final double SINGULAR = 1e-40;

    private Block3() {
    }

    /** y[yAt..] += sign A x[xAt..], or sign A^T x if A is transposed. */
    static void addProduct(double sign, double[] a, int at, boolean transposed, double[] x, int xAt, double[] y,
            int yAt) {
        int next = transposed ? 3 : 1;
        double x0 = x[xAt];
        double x1 = x[xAt + 1];
        double x2 = x[xAt + 2];
        for (int row = 0, e = at; row < 3; row++, e += 4 - next) {
            y[yAt + row] += sign * (a[e] * x0 + a[e + next] * x1 + a[e + 2 * next] * x2);
        }
    }

    /** C += sign A B, or sign A B^T if B is transposed; C is another block than A and B. */
    static void addBlockProduct(double sign, double[] a, int at, double[] b, int bAt, boolean transposed, double[] c,
            int cAt) {
        int next = transposed ? 1 : 3;
        for (int row = 0; row < 9; row += 3) {
            double a0 = a[at + row];
            double a1 = a[at + row + 1];
            double a2 = a[at + row + 2];
            for (int column = 0, e = bAt; column < 3; column++, e += 4 - next) {
                c[cAt + row + column] += sign * (a0 * b[e] + a1 * b[e + next] + a2 * b[e + 2 * next]);
            }
        }
    }

    /** The inverse of A by its adjugate; false if A is singular or not finite. */
    static boolean invert(double[] a, int at, double[] inverse, int to) {
        double largest = 0;
        for (int e = at; e < at + 9; e++) {
            largest = Math.max(largest, Math.abs(a[e]));
        }
        if (!(largest > 0 && largest <= Double.MAX_VALUE)) {
            return false;
        }
        double s = 1 / largest;                         // scaled, so that the determinant neither over- nor underflows
        double determinant = 0;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                double cofactor = entry(a, at, s, i + 1, j + 1) * entry(a, at, s, i + 2, j + 2)
                        - entry(a, at, s, i + 1, j + 2) * entry(a, at, s, i + 2, j + 1);
                inverse[to + 3 * j + i] = cofactor;
                determinant += i == 0 ? entry(a, at, s, i, j) * cofactor : 0;
            }
        }
        double scale = s / determinant;                 // once: the page's compiler drops brackets in a (b / c)
        for (int e = to; e < to + 9; e++) {
            inverse[e] *= scale;
        }
        return Math.abs(determinant) > SINGULAR;
    }

    /** An entry times s, with rows and columns counted on cyclically. */
    private static double entry(double[] a, int at, double s, int row, int column) {
        return a[at + 3 * (row % 3) + column % 3] * s;
    }
}
