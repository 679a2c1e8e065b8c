package particles.reactions;

import particles.law.Particles;
import particles.reactions.Row.Kind;

/**
 * The second phase, which evaluates gathered rows at a state: gaps, velocities and normals, the matrix A and the right
 * sides b.
 */
final class EvaluatePhase {
    private static final int STRIDE = Particles.STRIDE;

    final SlidingFriction sliding;
    private final Contacts contacts;
    private double[] accelerations = {};                // of moving anchors, and W F of a block's particles

    EvaluatePhase(Contacts contacts) {
        this.contacts = contacts;
        sliding = new SlidingFriction(contacts);
    }

    /** Prepares for a state, once for all blocks. */
    void prepare(double[] state, double time) {
        accelerations = accelerations.length < state.length ? new double[state.length] : accelerations;
        contacts.system.putAnchorAccelerations(time, accelerations);
    }

    /** The accelerations of moving anchors at the prepared state, in the entries of their velocities (m/s&sup2;). */
    double[] getAccelerations() {
        return accelerations;
    }

    /** Evaluates the rows of a block, without friction. */
    void evaluate(Block block, double[] state) {
        for (Row row : block.rows) {
            row.evaluate(state);
            row.bend *= block.isJoined() ? 1 : contacts.particles.mass(block.particles[0]);
        }
    }

    /** Adds the friction of sliding contacts to the forces of rows per 1 N, see {@link SlidingFriction#add}. */
    void addFriction(Block block, boolean pushKnown, double[] force, double[] state) {
        for (Row row : block.rows) {
            sliding.add(block.rows, row, pushKnown, force, state);
        }
    }

    /** Assembles the matrix. */
    void assemble(Block block) {
        for (int r = 0; r < block.rows.length; r++) {
            Row row = block.rows[r];
            for (int c = block.matrix.first(r); c <= r; c++) {
                Row column = block.rows[c];
                block.matrix.set(r, c, c == r && row.kind == Kind.SURFACE ? block.weight(row.first)
                        : entry(block, row, column), c == r ? 0 : entry(block, column, row));
            }
        }
    }

    private static double entry(Block block, Row row, Row column) {
        double sum = 0;
        for (int k = 0; k < 2; k++) {
            int i = row.movable[k];
            for (int l = 0; l < 2 && i >= 0; l++) {
                if (i == column.movable[l]) {
                    sum += block.weight(i) * Row.dot(row.gradient, 3 * k, column.pull, 3 * l);
                }
            }
        }
        return sum;
    }

    /**
     * b = -(J W F + J' v) - k_s C - k_d C', with C the distance for contacts. Where balls touch, contacts have no
     * feedback: in a dense packing, the errors of many could not decay at the same time.
     */
    void putForces(Block block, double[] force) {
        findAccelerations(block, force);
        for (Row row : block.rows) {
            double decay = !block.isJoined() || row.isContact() && block.hasPairs ? 0 : contacts.getFeedback();
            row.right = row.isIdle() ? 0 : -(row.times(accelerations, 3) + row.bend)
                    - decay * decay * row.value - 2 * decay * row.rate;
        }
    }

    /** b = -C, or -C' for velocities (place 3). */
    void putErrors(Block block, int place) {
        for (Row row : block.rows) {
            row.right = row.isIdle() ? 0 : -(place == 0 ? row.value : row.rate);
        }
    }

    /** W F of the particles that are not held. */
    private void findAccelerations(Block block, double[] force) {
        for (int i : block.particles) {
            double w = block.held.get(i) ? 0 : block.weight(i);
            for (int f = STRIDE * i + 3; f < STRIDE * (i + 1); f++) {
                accelerations[f] = w * force[f];
            }
        }
    }

    /** The largest acceleration in the equations of a block. */
    double scale(Block block, double[] force) {
        findAccelerations(block, force);
        double scale = 0;
        for (int i : block.particles) {
            for (int f = STRIDE * i + 3; f < STRIDE * (i + 1); f++) {
                scale = Math.max(scale, Math.abs(accelerations[f]));
            }
        }
        for (Row row : block.rows) {
            scale = Math.max(scale, Math.abs(row.right));
        }
        return scale;
    }
}
