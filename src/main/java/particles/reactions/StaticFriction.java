package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.law.Particles;
import particles.law.Scales.Skin;
import particles.law.Vector3;
import particles.reactions.NormalForces.Push;

/**
 * Decides whether static friction can hold the particles of a linkage that is statically indeterminate. The loads of
 * rods and balls between held particles are not unique, but the motion does not depend on them: friction holds if some
 * loads and some contact forces in the friction cones balance all forces. They are found in turns: each contact force
 * becomes the one that leaves the smallest force on its particle, then all loads together become those that leave the
 * smallest accelerations, as if nothing touched a surface. As all sets of allowed forces are convex, what is left over
 * falls to 0, or to the least possible; what then still moves is not held. (Alternating minimisation; compare M. Jean,
 * "The non-smooth contact dynamics method", 1999.)
 */
final class StaticFriction {
    private static final int MOST_SWEEPS = 1_000;
    private static final int HALVINGS = 60;

    private final SolvePhase solve;
    private final NormalForces normal;
    private final Block block;
    private final double[] state;
    private final double[] total;
    private final double[] balanced;                    // the forces without loads, balanced by the cones
    private final double[] left;                        // the same with loads
    private double size;                                // of all forces; 0 if no search was needed

    /** The contact force of a particle on a surface; all forces begin at an index. */
    private record Cone(int place, Vector3 normal, double friction, Skin skin, double[] force) {
        /** Balances what is left of the force on its particle, as far as it can. */
        void balance(double[] left, double[] balanced) {
            Vector3 before = Vector3.at(force, 0);
            Vector3 now = nearest(before.minus(Vector3.at(left, place)));
            now.put(force, 0);
            for (double[] sum : new double[][] {left, balanced}) {
                Vector3.at(sum, place).minus(before).plus(now).put(sum, place);
            }
        }

        private Vector3 nearest(Vector3 wanted) {
            double push = normal.dot(wanted);
            Vector3 against = normal.times(push).minus(wanted);
            return skin.toHold(against) <= friction * push ? wanted : nearest(push, against);
        }

        /** The normal force at which the distance has slope 0, found by bisection; what is balanced follows from it. */
        private Vector3 nearest(double push, Vector3 against) {
            double low = 0;
            double high = Math.max(0, push) + skin.toHold(against) / friction;
            for (int k = 0; k < HALVINGS && friction > 0; k++) {
                double middle = (low + high) / 2;
                Vector3 balanced = skin.balance(against, friction * middle);
                boolean isMore = (middle - push) * middle > against.minus(balanced).dot(balanced);
                low = isMore ? low : middle;
                high = isMore ? middle : high;
            }
            double most = friction > 0 ? low : Math.max(0, push);
            return normal.times(most).minus(skin.balance(against, friction * most));
        }
    }

    /**
     * @param block the rods and wires of particles that cannot move
     * @param total the forces without these loads (N), to which they are added
     */
    StaticFriction(NormalForces normal, Block block, double[] state, double[] total) {
        this.normal = normal;
        solve = normal.solve;
        this.block = block;
        this.state = state;
        this.total = total;
        balanced = total.clone();
        left = total.clone();
        if (!held().allMatch(i -> normal.margin(i, state, total) > 0)) {
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
            for (Push push : normal.find(i, state, total, true)) {
                cones.add(new Cone(place(i), push.normal(), push.surface().friction().staticCoefficient(),
                        solve.evaluate.sliding.skin(i, state, push.normal()), new double[3]));
            }
        });
        Block links = solve.gather.linksBetween(block, held().toArray());
        solve.evaluate.evaluate(links, state);
        double[] before = left.clone();
        for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
            cones.forEach(cone -> cone.balance(left, balanced));
            putLoads(links);
            if (held().noneMatch(i -> margin(i) < allowed(i) / 2 && hasChanged(i, before))) {
                break;
            }
            System.arraycopy(left, 0, before, 0, left.length);
        }
        links.addForces(total);
    }

    /** Whether what is left of the force on a particle still changes from sweep to sweep. */
    private boolean hasChanged(int i, double[] before) {
        Vector3 now = Vector3.at(left, place(i));
        return now.minus(Vector3.at(before, place(i))).length() > Tolerances.PROGRESS * now.length();
    }

    /** Finds the loads that leave the smallest accelerations of held particles, J W (F + J<sup>T</sup> load) = 0. */
    private void putLoads(Block links) {
        System.arraycopy(balanced, 0, left, 0, left.length);
        for (Row row : links.rows) {
            row.right = 0;
            for (int k = 0; k < 2; k++) {
                int i = row.particle(k);
                if (i >= 0 && block.held.get(i)) {
                    row.right -= block.weight(i) * Row.dot(row.gradient, 3 * k, left, place(i));
                }
            }
        }
        solve.solve(links, row -> true, true);
        links.addForces(left);
    }

    private static int place(int particle) {
        return Particles.STRIDE * particle + 3;
    }

    /** The forces with these loads (N). */
    double[] getForces() {
        return total;
    }

    /**
     * As {@link ContactQueries#holdMargin}; after a search, what may be left of the force less what is. Forces that
     * others balance hold a particle even if nothing presses it on.
     */
    double margin(int particle) {
        return size == 0 ? normal.margin(particle, state, total)
                : allowed(particle) - Vector3.at(left, place(particle)).length();
    }

    private double allowed(int particle) {
        Vector3 given = Vector3.at(total, place(particle));
        Vector3 withCones = Vector3.at(balanced, place(particle));
        Vector3 loads = Vector3.at(left, place(particle)).minus(withCones);
        return Tolerances.HELD * (given.norm1() + withCones.minus(given).norm1() + loads.norm1());
    }
}
