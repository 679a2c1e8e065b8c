package deSolvers.symplectic;

import deSolvers.FiniteCheck;
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
        BlockLayout.kick(state, dSdt, state.length, d, h);            // first guess: the acceleration as it was
        double largestBefore = largest(before, d, d);
        double change = 0;
        double scale = 0;
        for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
            source.getStateDerivative(state, dSdt);     // at (x, v, t) with the latest v
            if (iteration == 0) {
                source.requireFinite(dSdt);
            } else if (FiniteCheck.firstNonFinite(dSdt) >= 0) {
                break;                                  // diverged so far that the source overflows: not the source's fault
            }
            double last = change;
            change = 0;
            scale = largestBefore;
            for (int v = d; v < state.length; v += 2 * d) {
                for (int c = v; c < v + d; c++) {
                    double kicked = before[c] + h * dSdt[c];
                    double changed = Math.abs(kicked - state[c]);
                    double size = Math.abs(kicked);
                    if (changed > change) {             // seldom; Math.max would make each entry wait for the one before
                        change = changed;
                    }
                    if (size > scale) {
                        scale = size;
                    }
                    state[c] = kicked;
                }
            }
            if (!(scale <= Double.MAX_VALUE)) {
                break;                                  // diverged to infinity
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

    /** The largest position (from the first entry on) or velocity (from entry d on), by its size. */
    private static double largest(double[] state, int first, int d) {
        double largest = 0;
        for (int block = first; block < state.length; block += 2 * d) {
            for (int c = block; c < block + d; c++) {
                double size = Math.abs(state[c]);
                if (size > largest) {
                    largest = size;
                }
            }
        }
        return largest;
    }
}
