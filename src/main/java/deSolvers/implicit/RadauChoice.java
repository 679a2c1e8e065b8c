package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.linear.ImplicitWork;

/**
 * Which of the ways to solve the linear systems of the Radau method serves a source; each is made when it is first
 * needed.
 */
final class RadauChoice {
    /** Up to here, two particles, a full matrix, which pivots, costs no more than blocks. */
    private static final int SMALL = 12;

    private final ImplicitWork.Counter work;
    private int n;
    private RadauSystems dense;
    private RadauSystems blocks;
    private RadauSystems products;

    RadauChoice(ImplicitWork.Counter work) {
        this.work = work;
    }

    /** Forgets the systems of another size. */
    void resize(int n) {
        this.n = n;
        dense = null;
        blocks = null;
        products = null;
    }

    RadauSystems systemsFor(DEStateSource source) {
        boolean exactBlocks = ImplicitStage.givesBlocks(source)
                && ((JacobianStateSource) source).getJacobianBlocks() == JacobianStateSource.Blocks.EXACT;
        // Blocks that are not the whole Jacobian go with products, a difference each: a full matrix needs fewer of
        // them.
        if (exactBlocks && n > SMALL || ImplicitStage.givesBlocks(source) && n > ImplicitStage.LARGEST_DENSE) {
            blocks = blocks == null ? new BlockRadauSystems(work, n) : blocks;
            return blocks;
        }
        if (n <= ImplicitStage.LARGEST_DENSE) {
            dense = dense == null ? new DenseRadauSystems(work, n) : dense;
            return dense;
        }
        products = products == null ? new KrylovRadauSystems(work, n) : products;
        return products;
    }
}
