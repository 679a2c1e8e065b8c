package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Decides whether static friction can hold the particles of a linkage that is statically indeterminate. The loads of
 * rods and balls between held particles are not unique, but the motion does not depend on them: friction holds if some
 * loads and some contact forces in the friction cones balance all forces. They are found by projected Gauss-Seidel:
 * each contact force and each load in turn becomes the one that leaves the smallest force unbalanced. As all sets of
 * allowed forces are convex, what is left over falls to 0, or to the least possible. (M. Jean, "The non-smooth contact
 * dynamics method", 1999.)
 */
final class StaticFriction {
    private static final int MOST_SWEEPS = 5_000;
    /** What may be left of the force on a particle, relative to all forces. */
    private static final double ENOUGH = 1e-6;
    /** A sweep that takes less than this fraction of what is left is the last one. */
    private static final double PROGRESS = 1e-5;

    private final ContactQueries queries;
    private final Block block;
    private final double[] state;
    private final double[] total;
    private final double[] left;                        // of the forces, balanced by the cones
    private double size;                                // of all forces; 0 if no search was needed

    /** The contact force of a particle on a surface; all forces begin at an index. */
    private record Cone(int place, Vector3 normal, double friction, double[] force) {
        /** Balances what is left of the force on its particle, as far as it can. */
        void balance(double[] left) {
            Vector3 rest = Vector3.at(left, place).minus(Vector3.at(force, 0));
            nearest(rest.times(-1)).put(force, 0);
            rest.plus(Vector3.at(force, 0)).put(left, place);
        }

        private Vector3 nearest(Vector3 wanted) {
            double push = normal.dot(wanted);
            Vector3 across = wanted.minus(normal.times(push));
            double size = across.length();
            if (size <= friction * push) {
                return wanted;
            }
            double most = Math.max(0, (push + friction * size) / (1 + friction * friction));
            return normal.plus(across.times(size == 0 ? 0 : friction / size)).times(most);
        }
    }

    /**
     * @param block the rods and wires of particles that cannot move
     * @param total the forces without these loads (N), to which they are added
     */
    StaticFriction(ContactQueries queries, Block block, double[] state, double[] total) {
        this.queries = queries;
        this.block = block;
        this.state = state;
        this.total = total;
        left = total.clone();
        if (!held().allMatch(i -> queries.marginAlone(i, state, total) > 0)) {
            search();
        }
    }

    private IntStream held() {
        return Arrays.stream(block.particles).filter(block.held::get);
    }

    private void search() {
        List<Cone> cones = new ArrayList<>();
        held().forEach(i -> {
            size += Vector3.at(total, place(i)).norm1();
            Rows rows = queries.push(i, state, total).rows;
            for (int r = 0; r < rows.count; r++) {
                cones.add(new Cone(place(i), Vector3.at(rows.gradient, 6 * r), rows.friction(r).staticCoefficient(),
                        new double[3]));
            }
        });
        double[] loads = new double[block.rows.count];
        double before = Double.POSITIVE_INFINITY;
        for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
            cones.forEach(cone -> cone.balance(left));
            double now = 0;                             // falls in each sweep
            for (int i : held().toArray()) {
                now += block.weight(i) * Rows.dot(left, place(i), left, place(i));
            }
            if (now > (1 - PROGRESS) * before || held().allMatch(i -> margin(i) > ENOUGH / 2 * size)) {
                return;
            }
            before = now;
            for (int r = 0; r < loads.length; r++) {
                if (block.isIdle(r)) {
                    addLoad(r, loads);
                }
            }
        }
    }

    /** Adds the load of a row that leaves the smallest forces on its ends, weighted by 1/m. */
    private void addLoad(int r, double[] loads) {
        Rows rows = block.rows;
        double rate = 0;
        double mobility = 0;
        for (int k = 0; k < 2; k++) {
            int i = (k == 0 ? rows.first : rows.second)[r];
            if (i >= 0 && block.held.get(i)) {
                rate += block.weight(i) * Rows.dot(rows.gradient, 6 * r + 3 * k, left, place(i));
                mobility += block.weight(i) * Rows.dot(rows.gradient, 6 * r + 3 * k, rows.gradient, 6 * r + 3 * k);
            }
        }
        double more = mobility == 0 ? 0 : -rate / mobility;
        more = rows.kind[r] == Rows.Kind.BALLS ? Math.max(more, -loads[r]) : more;
        loads[r] += more;
        rows.addForce(r, more, total);
        rows.addForce(r, more, left);
    }

    private static int place(int particle) {
        return Particles.STRIDE * particle + 3;
    }

    /** The forces with these loads (N). */
    double[] getForces() {
        return total;
    }

    /** As {@link RestingContacts#holdMargin}. */
    double margin(int particle) {
        return size == 0 ? queries.marginAlone(particle, state, total)
                : ENOUGH * size - Vector3.at(left, place(particle)).length();
    }
}
