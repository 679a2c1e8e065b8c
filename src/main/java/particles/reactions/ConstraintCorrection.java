package particles.reactions;

import deSolvers.text.Digits;
import java.util.Optional;
import particles.SimulationException;
import particles.law.Particles;

/**
 * Projects positions and velocities onto the constraints. Positions are corrected by Newton's method with the smallest
 * mass-weighted moves, W J<sup>T</sup> mu with J W J<sup>T</sup> mu = -C; velocities by one such system for C'.
 */
final class ConstraintCorrection {
    /** Target error, relative to a row's scale plus its particle's distance from the origin; less is round-off. */
    private static final double FINE = 1e-15;
    /** Accepted error of nearly singular configurations, where round-off is larger. */
    private static final double ENOUGH = 1e-12;
    private static final int MOST_ITERATIONS = 30;

    private final ConstraintRows rows;
    private final Linkages linkages;
    private final Optional<CoupledContacts> coupled;
    private final double[] right;
    private final double[] amount;

    ConstraintCorrection(ConstraintRows rows, Linkages linkages, Optional<CoupledContacts> coupled) {
        this.coupled = coupled;
        this.rows = rows;
        this.linkages = linkages;
        right = new double[rows.count()];
        amount = new double[rows.count()];
    }

    /** @return whether anything was moved */
    boolean positions(double[] state, double time, double[] mobility) {
        double before = Double.POSITIVE_INFINITY;
        for (int iteration = 0;; iteration++) {
            rows.evaluate(state);
            double error = 0;
            for (int r = 0; r < right.length; r++) {
                right[r] = -rows.value[r];
                int x = Particles.STRIDE * rows.first(r);
                double place = Math.abs(state[x]) + Math.abs(state[x + 1]) + Math.abs(state[x + 2]);
                error = Math.max(error, Math.abs(right[r]) / (rows.scale(r) + place));
            }
            if (!(error <= Double.MAX_VALUE)) {
                throw new SimulationException(time, -1, "a step ends with positions too large to compute with", null);
            }
            if (error <= FINE || error <= ENOUGH && error > before / 2) {
                return iteration > 0;
            }
            if (iteration == MOST_ITERATIONS) {
                throw new SimulationException(time, -1, "no positions satisfy the rods and wires at t = " + time
                        + " s: after " + iteration + " iterations the relative error of their lengths is still "
                        + Digits.few(error), null);
            }
            before = error;
            correct(mobility, state, 0);
        }
    }

    /** @return whether anything was changed */
    boolean velocities(double[] state, double[] mobility) {
        rows.evaluate(state);
        boolean changed = false;
        for (int r = 0; r < right.length; r++) {
            right[r] = -rows.rate[r];
            int v = Particles.STRIDE * rows.first(r) + 3;
            double speed = Math.abs(state[v]) + Math.abs(state[v + 1]) + Math.abs(state[v + 2]);
            changed |= Math.abs(right[r]) > FINE * (1 + speed);
        }
        if (changed) {
            correct(mobility, state, 3);
        }
        return changed;
    }

    private void correct(double[] mobility, double[] state, int place) {
        for (int l = 0; l < linkages.count(); l++) {
            Linkage linkage = linkages.get(l);
            if (coupled.isPresent() && coupled.get().correct(linkage, state, place)) {
                continue;
            }
            linkage.factorise(mobility);
            linkage.solve(right, amount);
            for (int row : linkage.members()) {
                rows.move(row, amount[row], mobility, state, place);
            }
        }
    }
}
