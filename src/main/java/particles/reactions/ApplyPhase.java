package particles.reactions;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.Row.Kind;

/**
 * The last phase, which applies a solution: it adds forces, or moves particles and changes their velocities. A sticking
 * particle does not move; its contact force balances all others.
 */
final class ApplyPhase {
    private static final int STRIDE = Particles.STRIDE;

    private static final int MOST_ITERATIONS = 30;

    private final Contacts contacts;
    private final GatherPhase gather;
    private final EvaluatePhase evaluate;
    final SolvePhase solve;

    ApplyPhase(SolvePhase solve) {
        this.solve = solve;
        contacts = solve.contacts;
        gather = solve.gather;
        evaluate = solve.evaluate;
    }

    /**
     * Adds the forces of a block, after {@link EvaluatePhase#prepare}.
     *
     * @param force the forces of all effects (N)
     * @param power what the power of each row is (W)
     * @return the sum of the powers (W)
     */
    double addForces(Block block, double[] state, double time, double[] force, ToDoubleFunction<Row> power) {
        double sum = power(block, state, time, force, power);
        block.addForces(force);
        addRest(block, force);
        for (int i = block.held.nextSetBit(0); i >= 0; i = block.held.nextSetBit(i + 1)) {
            Arrays.fill(force, STRIDE * i + 3, STRIDE * (i + 1), 0.0);
        }
        return sum;
    }

    /** The sum of a power over the rows of a block (W), after {@link EvaluatePhase#prepare}. */
    private double power(Block block, double[] state, double time, double[] force, ToDoubleFunction<Row> power) {
        solve.solveForces(block, state, time, force);
        double sum = 0;
        for (Row row : block.rows) {
            sum += power.applyAsDouble(row);
        }
        return sum;
    }

    /**
     * Adds what round-off has left of forces between very light and very heavy particles: where a light one carries a
     * heavy one, the force on it is the small difference of large ones. Twice, since the matrix is rounded too.
     */
    private void addRest(Block block, double[] force) {
        if (block.massRatio > Tolerances.UNEVEN) {
            Row[] all = block.rows;
            double[] forces = Arrays.stream(all).mapToDouble(row -> row.force).toArray();
            gather.keep(block, Arrays.stream(all).filter(row -> row.force != 0));
            for (int k = 0; k < 2; k++) {
                evaluate.putForces(block, force);
                solve.solve(block, row -> false, false);
                block.addForces(force);
            }
            gather.keep(block, Arrays.stream(all));
            for (int r = 0; r < all.length; r++) {
                all[r].force = forces[r];
            }
        }
    }

    /** Adds the forces of all coupled particles to those of all effects (N). */
    void addForces(double[] state, double time, double[] force) {
        evaluate.prepare(state, time);
        gather.joined().forEach(block -> addForces(block, state, time, force, row -> 0));
    }

    /** The sum of a power over the rows of all coupled particles (W). */
    double power(double[] state, double time, double[] force, ToDoubleFunction<Row> power) {
        evaluate.prepare(state, time);
        return gather.joined().stream().mapToDouble(block -> power(block, state, time, force, power)).sum();
    }

    /**
     * Corrects positions or velocities by C or C': on rods, wires, touched surfaces and, if they are meant, balls.
     *
     * @param place   0 for positions, 3 for velocities
     * @param mayOpen whether particles may leave contacts
     * @param balls   whether balls in contact are meant
     */
    void correct(Block block, double[] state, int place, boolean mayOpen, boolean balls) {
        gather.gather(block, balls);
        correct(block, state, place, mayOpen);
    }

    /** As {@link #correct(Block, double[], int, boolean, boolean)}, for the rows that were gathered. */
    void correct(Block block, double[] state, int place, boolean mayOpen) {
        evaluate.evaluate(block, state);
        evaluate.putErrors(block, place);
        solve.solve(block, row -> mayOpen, mayOpen);
        move(block, state, place);
    }

    /**
     * Moves the particles of a block along its rows by the solution, without friction.
     *
     * @param place 0 to move positions, 3 to change velocities
     */
    void move(Block block, double[] state, int place) {
        for (Row row : block.rows) {
            for (int k = 0; k < 2; k++) {
                int i = row.movable[k];
                for (int c = 0; c < 3 && i >= 0; c++) {
                    state[STRIDE * i + place + c] += block.weight(i) * row.force * row.gradient[3 * k + c];
                }
            }
        }
    }

    /**
     * Projects positions, then velocities, onto rods and wires; contacts of balls are corrected by their own rule. A
     * rod whose two ends are held by friction is corrected once one of them moves. Positions are corrected by Newton's
     * method with the smallest mass-weighted moves, W J<sup>T</sup> mu with J W J<sup>T</sup> mu = -C; velocities by
     * one such system for C'.
     *
     * @return whether anything was changed
     */
    boolean project(double[] state, double time) {
        List<Row> rows = contacts.rows.stream().filter(row -> row.kind != Kind.BALLS && !gather.isHeld(row)).toList();
        boolean moved = projectPositions(rows, state, time);
        boolean changed = rows.stream().anyMatch(row -> Math.abs(row.rate)        // known since the last correction
                > Tolerances.LENGTH * (1 + Vector3.at(state, STRIDE * row.first + 3).norm1()));
        if (changed) {
            correct(state, 3);
        }
        return changed || moved;
    }

    private boolean projectPositions(List<Row> rows, double[] state, double time) {
        double before = Double.POSITIVE_INFINITY;
        for (int iteration = 0;; iteration++) {
            double error = 0;
            for (Row row : rows) {
                row.evaluate(state);
                double place = Vector3.at(state, STRIDE * row.first).norm1();
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
        for (Block block : gather.joined()) {
            correct(block, state, place, false, false);
        }
    }
}
