package deSolvers.symplectic;

import deSolvers.GuardedStep;

/**
 * The kick that closes a symplectic step where the acceleration depends on the velocity: v = v0 + h a(x, v, t) is solved
 * for v by fixed-point iteration. Taken explicitly, the kick would not be the mirror image of the one that opened the
 * step, and the order would fall to 1.
 */
final class ClosingKick {
    /** Relative to the velocities; some hundred roundings, reached where an iteration leaves less than 0.74 of a change. */
    private static final double TOLERANCE = 1e-13;
    /** Of the largest position: what a step's end may be moved by where the change of the velocity no longer falls. */
    private static final double ROUNDING = 0x1p-50;
    private static final int MOST_ITERATIONS = 100;

    private double[] before = {};                       // the velocities alone, from which the kick starts
    private double largestBefore;                       // of their sizes; NaN if one is
    private double change;                              // the largest one of a velocity in the last iteration
    private double scale;                               // about the largest velocity: before, and how far off the guess was

    /**
     * The opening kick and the drift, as {@link BlockLayout#kickDrift} does them, and a first guess at the closing kick: the
     * acceleration as it was. In one pass, because on large systems each costs as much as a part of the springs.
     *
     * @param from   (x, v) at the beginning; n long
     * @param dSdt   the derivative there; n long
     * @param n      how many entries these arrays have
     * @param d      positions in a block
     * @param h      the leapfrog's length (s); each of the kicks takes half of it
     * @param state  another array; receives x' and the guess at v'; n long
     */
    void open(double[] from, double[] dSdt, int n, int d, double h, double[] state) {
        if (before.length != n / 2) {
            before = new double[n / 2];
        }
        double largest = 0;
        int j = 0;
        if (d == 3) {                                   // written out: an inner loop over three entries takes twice as long
            for (int x = 0; x < n; x += 6) {
                largest = larger(Math.abs(open(from, dSdt, x, x + 3, h, state, j)), largest);
                largest = larger(Math.abs(open(from, dSdt, x + 1, x + 4, h, state, j + 1)), largest);
                largest = larger(Math.abs(open(from, dSdt, x + 2, x + 5, h, state, j + 2)), largest);
                j += 3;
            }
        } else {
            for (int block = 0; block < n; block += 2 * d) {
                for (int x = block; x < block + d; x++) {
                    largest = larger(Math.abs(open(from, dSdt, x, x + d, h, state, j++)), largest);
                }
            }
        }
        largestBefore = largest;
    }

    /** One position at x and its velocity at v, which is the j-th. */
    private double open(double[] from, double[] dSdt, int x, int v, double h, double[] state, int j) {
        double velocity = BlockLayout.move(from, from[v], dSdt, x, v, h / 2, h, state);
        before[j] = velocity;
        state[v] = Math.fma(h / 2, dSdt[v], velocity);
        return velocity;
    }

    /**
     * Solves for the velocities, after {@link #open}.
     *
     * @param source the step's source, its clock already at the kick's time
     * @param state  holds x and a guess at v; receives v
     * @param dSdt   receives the derivative at (x, v)
     * @param d      positions in a block
     * @param h      the kick's length (s)
     */
    void solve(GuardedStep source, double[] state, double[] dSdt, int d, double h) {
        for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
            source.getStateDerivative(state, dSdt);     // at (x, v, t) with the latest v
            double last = change;
            kickAgain(state, dSdt, d, h);
            if (iteration == 0) {
                scale = largestBefore + change;
            }
            if (!(change <= Double.MAX_VALUE)) {
                if (iteration == 0) {
                    source.requireFinite(dSdt);
                }
                break;                                  // diverged so far that the source overflows: not the source's fault
            }
            if (change <= TOLERANCE * scale) {
                return;
            }
            if (iteration > 0 && change >= last && change * Math.abs(h) <= ROUNDING * largestPosition(state, d)) {
                return;                                 // near rest, where large forces cancel, rounding is all that is left
            }
        }
        throw source.failure(-1, "the velocity at the end of the step was not found in " + MOST_ITERATIONS
                + " iterations (last change " + change + " of " + scale + "); drag or spring damping is too stiff for"
                + " this deltaT: take a smaller one or an implicit solver");
    }

    /** Kicks the velocities anew from where they were before, and measures the largest change. */
    private void kickAgain(double[] state, double[] dSdt, int d, double h) {
        if (d == 3) {
            kickVectors(state, dSdt, h);
            return;
        }
        change = 0;
        int j = 0;
        for (int v = d; v < state.length; v += 2 * d) {
            for (int c = v; c < v + d; c++) {
                double kicked = Math.fma(h, dSdt[c], before[j++]);
                change = larger(Math.abs(kicked - state[c]), change);
                state[c] = kicked;
            }
        }
    }

    /** The same in space, written out. */
    private void kickVectors(double[] state, double[] dSdt, double h) {
        double[] before = this.before;
        double change = 0;
        int j = 0;
        for (int v = 3; v < state.length; v += 6) {
            double vx = Math.fma(h, dSdt[v], before[j]);
            double vy = Math.fma(h, dSdt[v + 1], before[j + 1]);
            double vz = Math.fma(h, dSdt[v + 2], before[j + 2]);
            j += 3;
            change = larger(Math.abs(vx - state[v]), change);
            change = larger(Math.abs(vy - state[v + 1]), change);
            change = larger(Math.abs(vz - state[v + 2]), change);
            state[v] = vx;
            state[v + 1] = vy;
            state[v + 2] = vz;
        }
        this.change = change;
    }

    /** The larger size, NaN if one is: seldom the first one, and Math.max would make each entry wait for the one before. */
    private static double larger(double size, double largest) {
        return size <= largest ? largest : Double.isNaN(largest) ? largest : size;
    }

    /** The largest position by its size; NaN if one is. */
    private static double largestPosition(double[] state, int d) {
        double largest = 0;
        for (int block = 0; block < state.length; block += 2 * d) {
            for (int x = block; x < block + d; x++) {
                largest = larger(Math.abs(state[x]), largest);
            }
        }
        return largest;
    }
}
