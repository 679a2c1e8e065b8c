package deSolvers.symplectic;

import deSolvers.GuardedStep;

/**
 * The kick that closes a symplectic step where the acceleration depends on the velocity: v = v0 + h a(x, v, t) is solved
 * for v by fixed-point iteration. Taken explicitly, the kick would not be the mirror image of the one that opened the
 * step, and the order would fall to 1.
 */
final class ClosingKick {
    /** Relative to the largest velocity; some hundred roundings, always reached where the iteration converges. */
    private static final double TOLERANCE = 1e-13;
    /** Of the largest position: what a step's end may be moved by where the change of the velocity no longer falls. */
    private static final double ROUNDING = 0x1p-50;
    private static final int MOST_ITERATIONS = 100;

    private double[] before = {};
    private double change;                              // the largest one of a velocity in the last iteration
    private double scale;                               // the largest velocity, before the kick or after; NaN if one is

    /**
     * Solves for the velocities and leaves the source at the new state.
     *
     * @param source the step's source, its clock already at the kick's time
     * @param state  holds x and, before the kick, v0; receives v
     * @param dSdt   holds the derivative of the last kick, for a first guess; receives the derivative at (x, v)
     * @param d      positions in a block
     * @param h      the kick's length (s)
     */
    void solve(GuardedStep source, double[] state, double[] dSdt, int d, double h) {
        if (before.length != state.length) {
            before = new double[state.length];
        }
        System.arraycopy(state, 0, before, 0, state.length);
        BlockLayout.kick(state, dSdt, state.length, d, h); // first guess: the acceleration as it was
        double largestBefore = largest(before, d, d);
        for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
            source.getStateDerivative(state, dSdt);     // at (x, v, t) with the latest v
            if (iteration == 0) {
                source.requireFinite(dSdt);
            }
            double last = change;
            scale = largestBefore;
            kickAgain(state, dSdt, d, h);
            if (!(scale <= Double.MAX_VALUE)) {
                break;                                  // diverged so far that the source overflows: not the source's fault
            }
            if (change <= TOLERANCE * scale) {
                return;
            }
            if (iteration > 0 && change >= last && change * Math.abs(h) <= ROUNDING * largest(state, 0, d)) {
                return;                                 // near rest, where large forces cancel, rounding is all that is left
            }
        }
        throw source.failure(-1, "the velocity at the end of the step was not found in " + MOST_ITERATIONS
                + " iterations (last change " + change + " of " + scale + "); drag or spring damping is too stiff for"
                + " this deltaT: take a smaller one or an implicit solver");
    }

    /** Kicks the velocities anew from where they were before, and measures. */
    private void kickAgain(double[] state, double[] dSdt, int d, double h) {
        change = 0;
        if (d == 3) {
            kickVectors(state, dSdt, h);
            return;
        }
        for (int v = d; v < state.length; v += 2 * d) {
            for (int c = v; c < v + d; c++) {
                double kicked = before[c] + h * dSdt[c];
                change = larger(Math.abs(kicked - state[c]), change);
                scale = larger(Math.abs(kicked), scale);
                state[c] = kicked;
            }
        }
    }

    /** The same in space, written out: an inner loop over three entries takes twice as long. */
    private void kickVectors(double[] state, double[] dSdt, double h) {
        double[] before = this.before;
        double change = this.change;
        double scale = this.scale;
        for (int v = 3; v < state.length; v += 6) {
            double vx = before[v] + h * dSdt[v];
            double vy = before[v + 1] + h * dSdt[v + 1];
            double vz = before[v + 2] + h * dSdt[v + 2];
            change = larger(Math.abs(vx - state[v]), change);
            change = larger(Math.abs(vy - state[v + 1]), change);
            change = larger(Math.abs(vz - state[v + 2]), change);
            scale = larger(Math.abs(vx), scale);
            scale = larger(Math.abs(vy), scale);
            scale = larger(Math.abs(vz), scale);
            state[v] = vx;
            state[v + 1] = vy;
            state[v + 2] = vz;
        }
        this.change = change;
        this.scale = scale;
    }

    /** The larger size, NaN if one is: seldom the first one, and Math.max would make each entry wait for the one before. */
    private static double larger(double size, double largest) {
        return size <= largest ? largest : Double.isNaN(largest) ? largest : size;
    }

    /** The largest position (from the first entry on) or velocity (from entry d on), by its size; NaN if one is. */
    private static double largest(double[] state, int first, int d) {
        double largest = 0;
        if (d == 3) {
            for (int x = first; x < state.length; x += 6) {
                largest = larger(Math.abs(state[x]), largest);
                largest = larger(Math.abs(state[x + 1]), largest);
                largest = larger(Math.abs(state[x + 2]), largest);
            }
            return largest;
        }
        for (int block = first; block < state.length; block += 2 * d) {
            for (int c = block; c < block + d; c++) {
                largest = larger(Math.abs(state[c]), largest);
            }
        }
        return largest;
    }
}
