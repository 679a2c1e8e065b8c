package particles.rules;

import java.util.Arrays;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Finds the first root at which a polynomial becomes negative, by subdivision of its B&eacute;zier form: a piece
 * without negative coefficients is nowhere negative, so that no crossing is missed, however short. (Method: T.
 * Sederberg, T. Nishita 1990, B&eacute;zier clipping, with halving in place of clipping.)
 */
final class FirstCrossing {
    /** The number of coefficients of a squared cubic. */
    private static final int MOST_COEFFICIENTS = 7;
    private static final double SHORTEST_PIECE = 0x1p-45;
    /** Far more than 6 roots need, each at the end of 45 halvings; only round-off takes more. */
    private static final int MOST_PIECES = 10_000;

    private int searched;
    /** The path: the four B&eacute;zier points of a cubic (m). */
    private final double[] points = new double[12];
    private final double[] coefficients = new double[MOST_COEFFICIENTS];

    /** Begins with the path of a particle, the cubic between two states that are a time h apart (s). */
    void begin(double[] begin, double[] end, double h, int i) {
        Arrays.fill(points, 0);
        add(1, begin, end, h, i);
    }

    /** Adds a multiple of a particle's path. */
    void add(int factor, double[] begin, double[] end, double h, int i) {
        for (int c = 0, x = Particles.STRIDE * i; c < 3; c++, x++) {
            points[c] += factor * begin[x];
            points[3 + c] += factor * (begin[x] + h * begin[x + 3] / 3);
            points[6 + c] += factor * (end[x] - h * end[x + 3] / 3);
            points[9 + c] += factor * end[x];
        }
    }

    /** How far the path may get from its beginning (m): no point of it is beyond its B&eacute;zier points. */
    double reach() {
        double farthest = 0;
        for (int k = 3; k < points.length; k += 3) {
            farthest = Math.max(farthest, Vector3.at(points, k).minus(Vector3.at(points, 0)).length());
        }
        return farthest;
    }

    /** Puts a particle where it was at a fraction u of the path between two states; its velocity is interpolated. */
    void put(double u, double[] begin, double[] end, int i, double[] state) {
        for (int c = 0, x = Particles.STRIDE * i; c < 3; c++, x++) {
            state[x] = (1 - u) * (1 - u) * ((1 - u) * points[c] + 3 * u * points[3 + c])
                    + u * u * (3 * (1 - u) * points[6 + c] + u * points[9 + c]);
            state[x + 3] = (1 - u) * begin[x + 3] + u * end[x + 3];
        }
    }

    /** When the path first enters an obstacle that is raised by a height (m); NaN if it does not. */
    double into(Obstacle obstacle, double height) {
        double more = obstacle.raise(height);
        int count = obstacle.separation(points, coefficients);
        for (int k = 0; k < count; k++) {
            coefficients[k] += more;
        }
        return of(coefficients, count);
    }

    /**
     * @param coefficients B&eacute;zier coefficients, which are overwritten; for a cubic f: f(0), f(0) + f'(0)/3, f(1)
     *                     - f'(1)/3, f(1)
     * @param count        the number of coefficients
     * @return the u in 0 ... 1 where the polynomial first becomes negative, within 2^-45; NaN if it never does, or if a
     *         coefficient is not finite: such a path belongs to a run that the energy limit is about to end
     */
    double of(double[] coefficients, int count) {
        for (int k = 0; k < count; k++) {
            if (!Double.isFinite(coefficients[k])) {
                return Double.NaN;
            }
        }
        searched = 0;
        return search(coefficients, count, 0, 1);
    }

    private double search(double[] b, int count, double from, double to) {
        boolean outside = true;
        for (int k = 0; k < count; k++) {
            outside &= b[k] >= 0;
        }
        if (outside) {
            return Double.NaN;
        }
        if (b[0] < 0 || ++searched > MOST_PIECES) {
            return from;                                // after so many pieces: 0 but for round-off
        }
        if (to - from == SHORTEST_PIECE) {
            return b[count - 1] < 0 ? from : Double.NaN;
        }
        double half = (from + to) / 2;
        double[] left = new double[count];
        for (int level = 0; level < count; level++) {   // de Casteljau: b ends as the right half
            left[level] = b[0];
            for (int k = 0; k < count - 1 - level; k++) {
                b[k] = (b[k] + b[k + 1]) / 2;
            }
        }
        double first = search(left, count, from, half);
        return Double.isNaN(first) ? search(b, count, half, to) : first;
    }
}
