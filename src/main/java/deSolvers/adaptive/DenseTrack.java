package deSolvers.adaptive;

import java.util.Arrays;

/** The pieces of a step, each a polynomial in the state's entries, as long as one after the other is asked for. */
final class DenseTrack {
    private int pieces;
    private double[] offsets = {};                      // where each piece begins, from the beginning of the step (s)
    private double[] lengths = {};
    private double[] centres = {};
    private int[] degrees = {};
    private double[][][] coefficients = {};
    private boolean available;
    private double start;
    private double end;
    private int n;

    /** Forgets the last step. */
    void clear() {
        pieces = 0;
        available = false;
    }

    /** Tells nothing of the last step until {@link #resume}. */
    boolean suspend() {
        boolean wasAvailable = available;
        available = false;
        return wasAvailable;
    }

    /** After a step of no length the last one's states are still there, if they were. */
    void resume(boolean wasAvailable) {
        available = wasAvailable;
    }

    /** Room for one more piece: an array of n coefficients for each power of u, in [-centre, 1 - centre]. */
    double[][] add(double offset, double h, int n, int degree, double centre) {
        if (pieces == offsets.length) {
            int room = Math.max(8, 2 * pieces);
            offsets = Arrays.copyOf(offsets, room);
            lengths = Arrays.copyOf(lengths, room);
            centres = Arrays.copyOf(centres, room);
            degrees = Arrays.copyOf(degrees, room);
            coefficients = Arrays.copyOf(coefficients, room);
            Arrays.fill(coefficients, pieces, room, new double[0][]);
        }
        if (coefficients[pieces].length <= degree || coefficients[pieces][0].length != n) {
            coefficients[pieces] = new double[degree + 1][n];
        }
        offsets[pieces] = offset;
        lengths[pieces] = h;
        centres[pieces] = centre;
        degrees[pieces] = degree;
        return coefficients[pieces++];
    }

    /** All pieces are there. */
    void finish(double start, double end, int n) {
        this.start = start;
        this.end = end;
        this.n = n;
        available = true;
    }

    void getStateAt(double time, double[] result) {
        if (!available) {
            throw new IllegalStateException("no states in between: switch dense output on and make a step");
        }
        if (!(time >= Math.min(start, end) && time <= Math.max(start, end))) {
            throw new IllegalArgumentException("t = " + time + " lies outside the last step, from " + start + " to " + end);
        }
        if (result.length != n) {
            throw new IllegalArgumentException("an array of " + result.length + " for a state of " + n);
        }
        double offset = time - start;
        int piece = pieceAt(Math.abs(offset));
        double u = (offset - offsets[piece]) / lengths[piece] - centres[piece];
        double[][] c = coefficients[piece];
        int degree = degrees[piece];
        for (int i = 0; i < n; i++) {
            double value = c[degree][i];
            for (int power = degree - 1; power >= 0; power--) {
                value = value * u + c[power][i];
            }
            result[i] = value;
        }
    }

    private int pieceAt(double distance) {
        int low = 0;
        int high = pieces - 1;
        while (low < high) {                            // the last piece that does not begin beyond
            int mid = (low + high + 1) / 2;
            if (Math.abs(offsets[mid]) <= distance) {
                low = mid;
            } else {
                high = mid - 1;
            }
        }
        return low;
    }
}
