package particles.reactions;

import particles.law.Particles;
import particles.law.Vector3;
import particles.reactions.Rows.Kind;

/**
 * Decides whether static friction can hold a statically indeterminate linkage. The load of a rod between two sticking
 * ends is not unique, but the motion does not depend on it. Friction holds if it can hold all ends with at least one
 * load. The search maximises the smallest margin of all ends, a concave function of the load, one rod after the other,
 * by leaving out a third of the range of loads at a time.
 */
final class StaticFrictionFeasibility {
    /** They shorten the range of loads by a factor of 1e-12. */
    private static final int SECTIONS = 68;
    private static final int SWEEPS = 20;
    /** A sweep that gains less than this, relative to the forces on the ends, is the last one. */
    private static final double PROGRESS = 1e-6;
    /** The largest load that is tried, relative to the forces on the ends. */
    private static final double MOST = 100;

    private final ContactQueries queries;
    private final Block block;
    private final double[] state;
    private final double[] total;

    /**
     * @param block the rods and wires of particles that cannot move
     * @param total the forces without these loads (N); {@link #run} adds the loads
     */
    StaticFrictionFeasibility(ContactQueries queries, Block block, double[] state, double[] total) {
        this.queries = queries;
        this.block = block;
        this.state = state;
        this.total = total;
    }

    /** Adds the loads. */
    void run() {
        double size = 0;
        for (int i = block.held.nextSetBit(0); i >= 0; i = block.held.nextSetBit(i + 1)) {
            size += Vector3.at(total, Particles.STRIDE * i + 3).norm1();
        }
        double least = leastMargin(-1);
        for (int sweep = 0; sweep < SWEEPS && least <= 0; sweep++) {
            double before = least;
            int idle = 0;
            for (int r = 0; r < block.rows.count && least <= 0; r++) {
                if (block.isIdle(r)) {
                    load(r, MOST * size);
                    least = leastMargin(-1);
                    idle++;
                }
            }
            if (idle <= 1 || least - before <= PROGRESS * size) {
                return;
            }
        }
    }

    /** Adds the load of a row that is best for the smallest margin: that of its own ends, as others do not feel it. */
    private void load(int row, double most) {
        double others = leastMargin(row);
        double low = block.rows.kind[row] == Kind.BALLS ? 0 : -most;
        double high = most;
        for (int section = 0; section < SECTIONS; section++) {
            double x = low + (high - low) / 3;
            double y = high - (high - low) / 3;
            if (marginWith(row, x) >= marginWith(row, y)) {
                high = y;
            } else {
                low = x;
            }
        }
        double best = low + (high - low) / 2;
        if (Math.min(others, marginWith(row, 0)) < Math.min(others, marginWith(row, best))) {
            block.rows.addForce(row, best, total);
        }
    }

    /** The smaller margin of a row's ends under an additional load. */
    private double marginWith(int row, double load) {
        block.rows.addForce(row, load, total);
        double least = Math.min(margin(block.rows.first[row]), margin(block.rows.second[row]));
        block.rows.addForce(row, -load, total);
        return least;
    }

    private double margin(int i) {
        return i >= 0 && block.held.get(i) ? queries.holdSlack(i, state, total) : Double.POSITIVE_INFINITY;
    }

    /** The smallest margin of all ends but those of a row. */
    private double leastMargin(int row) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = block.held.nextSetBit(0); i >= 0; i = block.held.nextSetBit(i + 1)) {
            least = row >= 0 && (i == block.rows.first[row] || i == block.rows.second[row]) ? least
                    : Math.min(least, margin(i));
        }
        return least;
    }
}
