package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.SecondOrderStateSource;

/**
 * Chooses how I - g J is solved, by the kind and the size of the source: particles with blocks by sparse matrices for
 * the velocities, other sources by a full matrix.
 */
final class JacobianChoice {
    /** Up to this size a full matrix is faster than GMRES with blocks that are only a preconditioner. */
    private static final int SMALL = 600;
    /** A full matrix of this size has 200 MB. */
    static final int LARGEST_DENSE = 5000;

    private final ImplicitWork.Counter work;
    private int n = -1;
    private ShiftedJacobian dense;
    private ShiftedJacobian blocks;

    JacobianChoice(ImplicitWork.Counter work) {
        this.work = work;
    }

    /** The form of I - g J for a source; each is made when it is first needed. */
    ShiftedJacobian of(DEStateSource source) {
        int size = source.getStateSize();
        if (size != n) {
            n = size;
            dense = null;
            blocks = null;
        }
        if (givesBlocks(source)) {
            blocks = blocks == null ? new ReducedVelocitySystem(work, n) : blocks;
            return blocks;
        }
        if (n > LARGEST_DENSE) {
            throw new IllegalArgumentException("an implicit solver needs a full matrix for "
                    + source.getClass().getName() + ", whose state has " + n + " entries; at most " + LARGEST_DENSE
                    + " are possible without " + JacobianStateSource.class.getName() + "'s blocks");
        }
        dense = dense == null ? new DenseSystem(work, n) : dense;
        return dense;
    }

    private boolean givesBlocks(DEStateSource source) {
        if (!(source instanceof JacobianStateSource known && source instanceof SecondOrderStateSource second)
                || second.getDimension() != 3) {
            return false;
        }
        JacobianStateSource.Blocks offered = known.getJacobianBlocks();
        return offered == JacobianStateSource.Blocks.EXACT
                || offered == JacobianStateSource.Blocks.APPROXIMATE && n > SMALL;
    }
}
