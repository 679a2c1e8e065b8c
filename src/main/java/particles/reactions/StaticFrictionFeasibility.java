package particles.reactions;

import java.util.BitSet;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Decides whether static friction can hold a statically indeterminate linkage. The load of a rod between two sticking
 * ends is not unique, but the motion does not depend on it. Friction holds if it can hold all ends with at least one
 * load. The search maximises the smallest margin of all ends, a concave function of the load, by golden section, one
 * rod after the other.
 */
final class StaticFrictionFeasibility {
    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;
    private static final int SECTIONS = 90;
    private static final int SWEEPS = 20;
    /** A sweep that gains less than this, relative to the forces on the ends, is the last one. */
    private static final double PROGRESS = 1e-6;
    /** The largest load that is tried, relative to the forces on the ends. */
    private static final double MOST = 100;

    private final ConstraintRows rows;
    private final ContactQueries queries;
    private BitSet ends = new BitSet();

    StaticFrictionFeasibility(ConstraintRows rows, ContactQueries queries) {
        this.rows = rows;
        this.queries = queries;
    }

    /**
     * Adds loads of the rods and wires of a block that cannot move.
     *
     * @param total the forces without these loads (N); the loads are added
     */
    void run(Block joint, double[] state, double[] total) {
        ends = joint.held;
        double size = 0;
        for (int i = ends.nextSetBit(0); i >= 0; i = ends.nextSetBit(i + 1)) {
            size += Vector3.at(total, Particles.STRIDE * i + 3).norm1();
        }
        double least = leastMargin(-1, state, total);
        for (int sweep = 0; sweep < SWEEPS && least <= 0; sweep++) {
            double before = least;
            int idle = 0;
            for (int r = 0; r < joint.size() && least <= 0; r++) {
                if (joint.isMember(r) && joint.isIdle(r)) {
                    load(joint.member(r), MOST * size, state, total);
                    least = leastMargin(-1, state, total);
                    idle++;
                }
            }
            if (idle <= 1 || least - before <= PROGRESS * size) {
                return;
            }
        }
    }

    /** Adds the load of a row that is best for the smallest margin: that of its own ends, as others do not feel it. */
    private void load(int row, double most, double[] state, double[] total) {
        double others = leastMargin(row, state, total);
        double low = rows.isContact(row) ? 0 : -most;
        double high = most;
        double x = high - GOLDEN * (high - low);
        double y = low + GOLDEN * (high - low);
        double atX = marginWith(row, x, state, total);
        double atY = marginWith(row, y, state, total);
        for (int section = 0; section < SECTIONS; section++) {
            if (atX >= atY) {
                high = y;
                y = x;
                atY = atX;
                x = high - GOLDEN * (high - low);
                atX = marginWith(row, x, state, total);
            } else {
                low = x;
                x = y;
                atX = atY;
                y = low + GOLDEN * (high - low);
                atY = marginWith(row, y, state, total);
            }
        }
        double best = low + (high - low) / 2;
        double without = Math.min(others, marginWith(row, 0, state, total));
        if (without < Math.min(others, marginWith(row, best, state, total))) {
            rows.addForce(row, best, total);
        }
    }

    /** The smaller margin of a row's ends under an additional load. */
    private double marginWith(int row, double load, double[] state, double[] total) {
        rows.addForce(row, load, total);
        double least = Math.min(margin(rows.first(row), state, total), margin(rows.second(row), state, total));
        rows.addForce(row, -load, total);
        return least;
    }

    private double margin(int i, double[] state, double[] total) {
        return i >= 0 && ends.get(i) ? queries.holdSlack(i, state, total) : Double.POSITIVE_INFINITY;
    }

    /** The smallest margin of all ends but those of a row. */
    private double leastMargin(int row, double[] state, double[] total) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = ends.nextSetBit(0); i >= 0; i = ends.nextSetBit(i + 1)) {
            least = row >= 0 && (i == rows.first(row) || i == rows.second(row)) ? least
                    : Math.min(least, queries.holdSlack(i, state, total));
        }
        return least;
    }
}
