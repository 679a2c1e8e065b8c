package deSolvers.symplectic;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;

/** The moves on the layout (x1, v1, x2, v2, ...) that all symplectic solvers are composed of. */
final class BlockLayout {
    private BlockLayout() {
    }

    /** The source as one of second order, or an error that says what is missing. */
    static SecondOrderStateSource secondOrder(DESolver solver, DEStateSource source) {
        if (!(source instanceof SecondOrderStateSource)) {
            throw new IllegalArgumentException(solver.getClass().getSimpleName() + " moves positions and velocities in"
                    + " turn and needs a " + SecondOrderStateSource.class.getName() + "; " + source.getClass().getName()
                    + " is only a " + DEStateSource.class.getName());
        }
        SecondOrderStateSource second = (SecondOrderStateSource) source;
        int d = second.getDimension();
        if (d < 1 || second.getStateSize() % (2 * d) != 0) {
            throw new IllegalArgumentException(source.getClass().getName() + " has dimension " + d + " and "
                    + second.getStateSize() + " state entries; the state has to be made of blocks of d positions and"
                    + " d velocities, d >= 1");
        }
        return second;
    }

    /**
     * A kick and then a drift with the new velocities: v' = v + kick a, x' = x + drift v'.
     *
     * @param state  (x, v)
     * @param dSdt   holds a in its velocity entries
     * @param d      positions in a block
     * @param kick   how long the acceleration acts (s)
     * @param drift  how long the new velocity acts (s)
     * @param result receives (x', v'); may be {@code state}
     */
    static void kickDrift(double[] state, double[] dSdt, int d, double kick, double drift, double[] result) {
        if (d == 3) {                                   // written out: the inner loop would cost as much as it does
            for (int x = 0; x < state.length; x += 6) {
                kickDrift(state, dSdt, x, x + 3, kick, drift, result);
                kickDrift(state, dSdt, x + 1, x + 4, kick, drift, result);
                kickDrift(state, dSdt, x + 2, x + 5, kick, drift, result);
            }
            return;
        }
        for (int block = 0; block < state.length; block += 2 * d) {
            for (int x = block; x < block + d; x++) {
                kickDrift(state, dSdt, x, x + d, kick, drift, result);
            }
        }
    }

    private static void kickDrift(double[] state, double[] dSdt, int x, int v, double kick, double drift, double[] result) {
        double velocity = state[v] + kick * dSdt[v];
        result[v] = velocity;
        result[x] = state[x] + drift * velocity;
    }

    /** Changes the velocities by an acceleration, read from the derivative's velocity entries: v += h a. */
    static void kick(double[] state, double[] dSdt, int d, double h) {
        for (int v = d; v < state.length; v += 2 * d) {
            for (int c = v; c < v + d; c++) {
                state[c] += h * dSdt[c];
            }
        }
    }
}
