package deSolvers.symplectic;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;

/** The layout (x1, v1, x2, v2, ...) of a source of second order, and the moves on it that symplectic solvers are composed of. */
final class BlockLayout {
    private BlockLayout() {
    }

    /** The source as one of second order, or an error that says what the solver misses. */
    static SecondOrderStateSource of(DESolver solver, DEStateSource source) {
        if (!(source instanceof SecondOrderStateSource)) {
            throw notOfSecondOrder(solver, source);
        }
        SecondOrderStateSource secondOrder = (SecondOrderStateSource) source;
        int n = secondOrder.getStateSize();
        int d = secondOrder.getDimension();
        if (d < 1 || n % (2 * d) != 0) {
            throw notOfBlocks(source, n, d);
        }
        return secondOrder;
    }

    private static IllegalArgumentException notOfSecondOrder(DESolver solver, DEStateSource source) {
        return new IllegalArgumentException(solver.getClass().getSimpleName() + " moves positions and velocities in"
                + " turn and needs a " + SecondOrderStateSource.class.getName() + "; " + source.getClass().getName()
                + " is only a " + DEStateSource.class.getName());
    }

    private static IllegalArgumentException notOfBlocks(DEStateSource source, int n, int d) {
        return new IllegalArgumentException(source.getClass().getName() + " has dimension " + d + " and "
                + n + " state entries; the state has to be made of blocks of d positions and"
                + " d velocities, d >= 1");
    }

    /**
     * A kick and then a drift with the new velocities: v' = v + kick a, x' = x + drift v'.
     *
     * @param state  (x, v)
     * @param dSdt   holds a in its velocity entries
     * @param n      how many entries these arrays have; where a source's size is a constant, this one is, and the loop no loop
     * @param d      positions in a block
     * @param kick   how long the acceleration acts (s)
     * @param drift  how long the new velocity acts (s)
     * @param result receives (x', v'); may be {@code state}
     */
    static void kickDrift(double[] state, double[] dSdt, int n, int d, double kick, double drift, double[] result) {
        kickDrift(state, dSdt, state, d, n, d, kick, drift, result);
    }

    /**
     * The same from the derivative at this very state: its position entries are v as well, and read there an entry that is not
     * finite makes the result NaN.
     */
    static void kickDriftFromDerivative(double[] state, double[] dSdt, int n, int d, double kick, double drift, double[] result) {
        kickDrift(state, dSdt, dSdt, 0, n, d, kick, drift, result);
    }

    /** Velocities are read in vs, each so many entries after its position's place. */
    private static void kickDrift(double[] state, double[] dSdt, double[] vs, int shift, int n, int d, double kick, double drift,
            double[] result) {
        if (d == 1) {                                   // written out: the inner loop would cost as much as it does
            for (int x = 0; x < n; x += 2) {
                move(state, vs[x + shift], dSdt, x, x + 1, kick, drift, result);
            }
            return;
        }
        if (d == 3) {
            for (int x = 0; x < n; x += 6) {
                move(state, vs[x + shift], dSdt, x, x + 3, kick, drift, result);
                move(state, vs[x + 1 + shift], dSdt, x + 1, x + 4, kick, drift, result);
                move(state, vs[x + 2 + shift], dSdt, x + 2, x + 5, kick, drift, result);
            }
            return;
        }
        for (int block = 0; block < n; block += 2 * d) {
            for (int x = block; x < block + d; x++) {
                move(state, vs[x + shift], dSdt, x, x + d, kick, drift, result);
            }
        }
    }

    /** One position at x and its velocity at v, which is v0 before; returns v'. */
    static double move(double[] state, double v0, double[] dSdt, int x, int v, double kick, double drift, double[] result) {
        double velocity = Math.fma(kick, dSdt[v], v0);
        result[v] = velocity;
        result[x] = Math.fma(drift, velocity, state[x]);
        return velocity;
    }

    /** Changes the velocities by an acceleration, read from the derivative's velocity entries: v += h a. */
    static void kick(double[] state, double[] dSdt, int n, int d, double h) {
        if (d == 1) {
            for (int v = 1; v < n; v += 2) {
                state[v] = Math.fma(h, dSdt[v], state[v]);
            }
            return;
        }
        if (d == 3) {
            for (int v = 3; v < n; v += 6) {
                state[v] = Math.fma(h, dSdt[v], state[v]);
                state[v + 1] = Math.fma(h, dSdt[v + 1], state[v + 1]);
                state[v + 2] = Math.fma(h, dSdt[v + 2], state[v + 2]);
            }
            return;
        }
        for (int v = d; v < n; v += 2 * d) {
            for (int c = v; c < v + d; c++) {
                state[c] = Math.fma(h, dSdt[c], state[c]);
            }
        }
    }
}
