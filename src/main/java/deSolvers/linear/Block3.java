package deSolvers.linear;

/** Arithmetic of 3 x 3 blocks that lie by rows in longer arrays. */
final class Block3 {
    /** A block whose determinant is smaller than this part of its largest entry cubed counts as singular. */
    private static final double SINGULAR = 1e-40;

    private Block3() {
    }

    /** y[yAt..] += A x[xAt..]. */
    static void multiplyAdd(double[] a, int at, double[] x, int xAt, double[] y, int yAt) {
        double x0 = x[xAt];
        double x1 = x[xAt + 1];
        double x2 = x[xAt + 2];
        y[yAt] += a[at] * x0 + a[at + 1] * x1 + a[at + 2] * x2;
        y[yAt + 1] += a[at + 3] * x0 + a[at + 4] * x1 + a[at + 5] * x2;
        y[yAt + 2] += a[at + 6] * x0 + a[at + 7] * x1 + a[at + 8] * x2;
    }

    /** y[yAt..] -= A x[xAt..]. */
    static void multiplySubtract(double[] a, int at, double[] x, int xAt, double[] y, int yAt) {
        double x0 = x[xAt];
        double x1 = x[xAt + 1];
        double x2 = x[xAt + 2];
        y[yAt] -= a[at] * x0 + a[at + 1] * x1 + a[at + 2] * x2;
        y[yAt + 1] -= a[at + 3] * x0 + a[at + 4] * x1 + a[at + 5] * x2;
        y[yAt + 2] -= a[at + 6] * x0 + a[at + 7] * x1 + a[at + 8] * x2;
    }

    /** y[0..2] += A^T x[xAt..]. */
    static void multiplyTransposedAdd(double[] a, int at, double[] x, int xAt, double[] y) {
        double x0 = x[xAt];
        double x1 = x[xAt + 1];
        double x2 = x[xAt + 2];
        y[0] += a[at] * x0 + a[at + 3] * x1 + a[at + 6] * x2;
        y[1] += a[at + 1] * x0 + a[at + 4] * x1 + a[at + 7] * x2;
        y[2] += a[at + 2] * x0 + a[at + 5] * x1 + a[at + 8] * x2;
    }

    /** C = A B^T; C is another block than A and B. */
    static void multiplyTransposed(double[] a, int at, double[] b, int bAt, double[] c, int cAt) {
        for (int row = 0; row < 9; row += 3) {
            for (int column = 0; column < 3; column++) {
                int j = bAt + 3 * column;
                c[cAt + row + column] = a[at + row] * b[j] + a[at + row + 1] * b[j + 1] + a[at + row + 2] * b[j + 2];
            }
        }
    }

    /** C = (A B)^T; C is another block than A and B. */
    static void transposedProduct(double[] a, int at, double[] b, int bAt, double[] c) {
        for (int row = 0; row < 3; row++) {
            int i = at + 3 * row;
            for (int column = 0; column < 3; column++) {
                int j = bAt + column;
                c[3 * column + row] = a[i] * b[j] + a[i + 1] * b[j + 3] + a[i + 2] * b[j + 6];
            }
        }
    }

    /** C = A^T. */
    static void transpose(double[] a, int at, double[] c, int cAt) {
        for (int e = 0; e < 9; e++) {
            c[cAt + e % 3 * 3 + e / 3] = a[at + e];
        }
    }

    /** C -= A B; B begins at 0. */
    static void subtractProduct(double[] a, int at, double[] b, double[] c, int cAt) {
        for (int row = 0; row < 9; row += 3) {
            double a0 = a[at + row];
            double a1 = a[at + row + 1];
            double a2 = a[at + row + 2];
            c[cAt + row] -= a0 * b[0] + a1 * b[3] + a2 * b[6];
            c[cAt + row + 1] -= a0 * b[1] + a1 * b[4] + a2 * b[7];
            c[cAt + row + 2] -= a0 * b[2] + a1 * b[5] + a2 * b[8];
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
        double a0 = a[at] * s;
        double a1 = a[at + 1] * s;
        double a2 = a[at + 2] * s;
        double a3 = a[at + 3] * s;
        double a4 = a[at + 4] * s;
        double a5 = a[at + 5] * s;
        double a6 = a[at + 6] * s;
        double a7 = a[at + 7] * s;
        double a8 = a[at + 8] * s;
        double c0 = a4 * a8 - a5 * a7;
        double c1 = a5 * a6 - a3 * a8;
        double c2 = a3 * a7 - a4 * a6;
        double determinant = a0 * c0 + a1 * c1 + a2 * c2;
        if (!(Math.abs(determinant) > SINGULAR)) {
            return false;
        }
        double d = s / determinant;
        inverse[to] = c0 * d;
        inverse[to + 1] = (a2 * a7 - a1 * a8) * d;
        inverse[to + 2] = (a1 * a5 - a2 * a4) * d;
        inverse[to + 3] = c1 * d;
        inverse[to + 4] = (a0 * a8 - a2 * a6) * d;
        inverse[to + 5] = (a2 * a3 - a0 * a5) * d;
        inverse[to + 6] = c2 * d;
        inverse[to + 7] = (a1 * a6 - a0 * a7) * d;
        inverse[to + 8] = (a0 * a4 - a1 * a3) * d;
        return true;
    }
}
