package deSolvers.symplectic;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;

/** The layout (x1, v1, x2, v2, ...) of a source of second order, and the moves on it that symplectic solvers are composed of. */
final class BlockLayout {
    private final DESolver solver;
    private DEStateSource seen;                         // looked at once: on small systems asking costs more than the step
    private SecondOrderStateSource secondOrder;
    private int size;
    private int dimension;

    /** @param solver whose sources these are, for its name in messages */
    BlockLayout(DESolver solver) {
        this.solver = solver;
    }

    /** The source as one of second order, or an error that says what is missing. */
    SecondOrderStateSource of(DEStateSource source) {
        if (source != seen) {
            secondOrder = asSecondOrder(source);
            size = -1;
            seen = source;
        }
        SecondOrderStateSource second = secondOrder;
        int n = second.getStateSize();
        int d = second.getDimension();
        if (n != size || d != dimension) {
            requireBlocks(n, d);
            size = n;
            dimension = d;
        }
        return second;
    }

    private SecondOrderStateSource asSecondOrder(DEStateSource source) {
        if (!(source instanceof SecondOrderStateSource)) {
            throw new IllegalArgumentException(solver.getClass().getSimpleName() + " moves positions and velocities in"
                    + " turn and needs a " + SecondOrderStateSource.class.getName() + "; " + source.getClass().getName()
                    + " is only a " + DEStateSource.class.getName());
        }
        return (SecondOrderStateSource) source;
    }

    private void requireBlocks(int n, int d) {
        if (d < 1 || n % (2 * d) != 0) {
            throw new IllegalArgumentException(seen.getClass().getName() + " has dimension " + d + " and "
                    + n + " state entries; the state has to be made of blocks of d positions and"
                    + " d velocities, d >= 1");
        }
    }

    /**
     * A kick and then a drift with the new velocities: v' = v + kick a, x' = x + drift v'.
     *
     * @param state  (x, v)
     * @param dSdt   holds a in its velocity entries
     * @param vs     where v is read: {@code state}, or {@code dSdt} where that is the derivative there, whose position entries
     *               are v as well; then an entry that is not finite makes the result NaN
     * @param n      how many entries these arrays have; where a source's size is a constant, this one is, and the loop no loop
     * @param d      positions in a block
     * @param kick   how long the acceleration acts (s)
     * @param drift  how long the new velocity acts (s)
     * @param result receives (x', v'); may be {@code state}
     */
    static void kickDrift(double[] state, double[] dSdt, double[] vs, int n, int d, double kick, double drift,
            double[] result) {
        int shift = vs == dSdt ? 0 : d;             // from a position's place to its velocity's
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
