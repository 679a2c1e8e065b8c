package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.SecondOrderStateSource;

/**
 * Chooses how I - g J is solved, by the kind and the size of the source: particles with blocks by sparse matrices for
 * the velocities, other small sources by a full matrix, and other large ones by products J w alone.
 */
final class JacobianChoice {
    /** States up to this size get a full matrix if they have no blocks. */
    static final int LARGEST_DENSE = 600;

    private final ImplicitWork.Counter work;
    private int n = -1;
    private ShiftedJacobian dense;
    private ShiftedJacobian blocks;
    private ShiftedJacobian products;

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
            products = null;
        }
        if (givesBlocks(source)) {
            blocks = blocks == null ? new ReducedVelocitySystem(work, n) : blocks;
            return blocks;
        }
        if (n <= LARGEST_DENSE) {
            dense = dense == null ? new DenseSystem(work, n) : dense;
            return dense;
        }
        products = products == null ? new ProductSystem(work, n) : products;
        return products;
    }

    /** Blocks that are only a preconditioner pay where a full matrix would be large. */
    private boolean givesBlocks(DEStateSource source) {
        if (!(source instanceof JacobianStateSource && source instanceof SecondOrderStateSource)
                || ((SecondOrderStateSource) source).getDimension() != 3) {
            return false;
        }
        JacobianStateSource.Blocks offered = ((JacobianStateSource) source).getJacobianBlocks();
        return offered == JacobianStateSource.Blocks.EXACT
                || offered == JacobianStateSource.Blocks.APPROXIMATE && n > LARGEST_DENSE;
    }
}
