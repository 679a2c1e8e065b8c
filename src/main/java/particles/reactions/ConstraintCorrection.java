package particles.reactions;

import deSolvers.text.Digits;
import java.util.List;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Projects positions and velocities onto rods and wires; contacts of balls are corrected by their own rule, and rods
 * between particles that friction holds once one of them moves again.
 * Positions are corrected by Newton's method with the smallest mass-weighted moves, W J<sup>T</sup> mu with J W
 * J<sup>T</sup> mu = -C; velocities by one such system for C'.
 */
final class ConstraintCorrection {
    /** Target error, relative to a row's length plus its particle's distance from the origin; less is round-off. */
    private static final double FINE = 1e-15;
    /** Accepted error of nearly singular configurations, where round-off is larger. */
    private static final double ENOUGH = 1e-9;
    private static final int MOST_ITERATIONS = 30;

    private final Blocks blocks;
    private final List<Row> rows;

    ConstraintCorrection(Blocks blocks) {
        this.blocks = blocks;
        rows = blocks.getRows().list.stream().filter(row -> row.kind != Row.Kind.BALLS && !blocks.isHeld(row)).toList();
    }

    /** Corrects positions, then velocities; returns whether anything was changed. */
    boolean project(double[] state, double time) {
        boolean moved = positions(state, time);
        boolean changed = rows.stream().anyMatch(row -> Math.abs(row.rate)        // known since the last correction
                > FINE * (1 + Vector3.at(state, Particles.STRIDE * row.first + 3).norm1()));
        if (changed) {
            correct(state, 3);
        }
        return changed || moved;
    }

    /** @return whether anything was moved */
    private boolean positions(double[] state, double time) {
        double before = Double.POSITIVE_INFINITY;
        for (int iteration = 0;; iteration++) {
            double error = 0;
            for (Row row : rows) {
                row.evaluate(state);
                double place = Vector3.at(state, Particles.STRIDE * row.first).norm1();
                error = Math.max(error, Math.abs(row.value) / (row.length + place));
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
            correct(state, 0);
        }
    }

    private void correct(double[] state, int place) {
        for (Block block : blocks.joined()) {
            blocks.correct(block, state, place, false, Block.NONE);
        }
    }
}
