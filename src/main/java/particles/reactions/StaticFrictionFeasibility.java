package particles.reactions;

import java.util.ArrayList;
import java.util.List;
import particles.law.Particles;

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
    /** The largest load that is tried, relative to the forces on the ends. */
    private static final double MOST = 100;

    private final ConstraintRows rows;
    private final RestingContacts contacts;
    private final List<Integer> ends = new ArrayList<>();

    StaticFrictionFeasibility(ConstraintRows rows, RestingContacts contacts) {
        this.rows = rows;
        this.contacts = contacts;
    }

    /**
     * Adds loads of the rods and wires of a linkage that cannot move.
     *
     * @param total the forces without these loads (N); the loads are added
     */
    void run(Linkage linkage, JointSystem joint, double[] state, double[] total) {
        ends.clear();
        double size = 0;
        for (int i : linkage.particles()) {
            if (joint.mobility[i] == 0) {
                ends.add(i);
                int f = Particles.STRIDE * i + 3;
                size += Math.abs(total[f]) + Math.abs(total[f + 1]) + Math.abs(total[f + 2]);
            }
        }
        if (leastMargin(state, total) > 0) {
            // friction holds without any load
            return;
        }
        int idle = 0;
        for (int r = 0; r < joint.constraintRows(); r++) {
            idle += joint.isIdle(r) ? 1 : 0;
        }
        for (int sweep = 0; sweep < (idle > 1 ? SWEEPS : idle); sweep++) {
            for (int r = 0; r < joint.constraintRows(); r++) {
                if (joint.isIdle(r)) {
                    load(joint.member(r), MOST * size, state, total);
                }
            }
        }
    }

    private void load(int row, double most, double[] state, double[] total) {
        double low = -most;
        double high = most;
        double x = high - GOLDEN * (high - low);
        double y = low + GOLDEN * (high - low);
        double atX = leastMargin(row, x, state, total);
        double atY = leastMargin(row, y, state, total);
        for (int section = 0; section < SECTIONS; section++) {
            if (atX >= atY) {
                high = y;
                y = x;
                atY = atX;
                x = high - GOLDEN * (high - low);
                atX = leastMargin(row, x, state, total);
            } else {
                low = x;
                x = y;
                atX = atY;
                y = low + GOLDEN * (high - low);
                atY = leastMargin(row, y, state, total);
            }
        }
        double best = low + (high - low) / 2;
        if (leastMargin(row, 0, state, total) < leastMargin(row, best, state, total)) {
            rows.addForce(row, best, total);
        }
    }

    private double leastMargin(int row, double load, double[] state, double[] total) {
        rows.addForce(row, load, total);
        double least = leastMargin(state, total);
        rows.addForce(row, -load, total);
        return least;
    }

    /** The smallest margin of all ends. */
    private double leastMargin(double[] state, double[] total) {
        double least = Double.POSITIVE_INFINITY;
        for (int i : ends) {
            least = Math.min(least, contacts.response().holdSlack(i, state, total));
        }
        return least;
    }
}
