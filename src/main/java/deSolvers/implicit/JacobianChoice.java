package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.linear.SolverWork;

/**
 * Chooses how I - g J is solved, by the kind and the size of the source: particles with blocks by sparse matrices for
 * the velocities, other sources by a full matrix.
 */
final class JacobianChoice {
    /**
     * Up to this size a full matrix, which costs about as many evaluations, serves where blocks are only a
     * preconditioner, as with rods, wires and balls in contact: its entries tell the round-off of rods between masses
     * of very different sizes.
     */
    private static final int SMALL = 100;
    /** J, the matrix and its factors then take 600 MB; radau's complex matrix and factors another 800 MB. */
    static final int LARGEST_DENSE = 5000;

    private final SolverWork work;
    private int n = -1;
    private ShiftedJacobian form;

    JacobianChoice(SolverWork work) {
        this.work = work;
    }

    /** The form of I - g J for a source; it is made anew when its kind or size changes. */
    ShiftedJacobian of(DEStateSource source) {
        int size = source.getStateSize();
        boolean blocks = source instanceof JacobianStateSource known
                && (known.hasExactJacobian() || size > SMALL);
        if (size != n || blocks != form instanceof ReducedVelocitySystem) {
            form = blocks ? new ReducedVelocitySystem(work, size) : dense(source, size);
            n = size;
        }
        return form;
    }

    private ShiftedJacobian dense(DEStateSource source, int n) {
        if (n > LARGEST_DENSE) {
            throw new IllegalArgumentException("an implicit solver needs a full matrix for "
                    + source.getClass().getName() + ", whose state has " + n + " entries; at most " + LARGEST_DENSE
                    + " are possible without " + JacobianStateSource.class.getName() + "'s blocks");
        }
        return new DenseSystem(work, n);
    }
}
