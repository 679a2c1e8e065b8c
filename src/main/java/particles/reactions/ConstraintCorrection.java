package particles.reactions;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.List;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Projects positions and velocities onto rods and wires; contacts of balls are corrected by their own rule. A rod whose
 * two ends are held by friction is corrected once one of them moves. Also adds what round-off has left of forces
 * between very light and very heavy particles: where a light one carries a heavy one, the force on it is the small
 * difference of large ones.
 * Positions are corrected by Newton's method with the smallest mass-weighted moves, W J<sup>T</sup> mu with J W
 * J<sup>T</sup> mu = -C; velocities by one such system for C'.
 */
final class ConstraintCorrection {
    /** Why there is no solution then. */
    static final String LOST = "join masses that differ by a factor of more than 1e12: what the lightest pass on is"
            + " lost in round-off";
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
                > Tolerances.LENGTH * (1 + Vector3.at(state, Particles.STRIDE * row.first + 3).norm1()));
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
            if (error <= Tolerances.LENGTH || error <= Tolerances.SINGULAR_LENGTH && error > before / 2) {
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

    /** Whether the masses of a block differ too much. */
    static boolean areUneven(Block block) {
        return block.massRatio > Tolerances.MOST_UNEVEN;
    }

    /** Adds what round-off has left of the forces of a solved block; twice, since its matrix is rounded too. */
    static void addRest(Blocks blocks, Block block, double[] force) {
        if (block.massRatio > Tolerances.UNEVEN) {
            Row[] all = block.rows;
            double[] forces = Arrays.stream(all).mapToDouble(row -> row.force).toArray();
            block.keep(Arrays.stream(all).filter(row -> row.force != 0));
            for (int k = 0; k < 2; k++) {
                blocks.putRight(block, force);
                block.solve(row -> false, false);
                block.addForces(force);
            }
            block.keep(Arrays.stream(all));
            for (int r = 0; r < all.length; r++) {
                all[r].force = forces[r];
            }
        }
    }
}
