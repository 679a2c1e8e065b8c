package particles.rules;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import particles.EventRule;
import particles.Motion;
import particles.ParticleSystem;
import particles.effects.NeighbourGrid;
import particles.law.Particles;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.law.Violation;
import particles.reactions.BallContacts;
import particles.reactions.RigidConstraints;

/**
 * Hard spheres: particles are balls that bounce off each other. Impacts are located like those with surfaces, see
 * {@link ExactImpacts}. With the unit vector N along the line of centres, the speed of approach v becomes the speed of
 * separation r v, and friction is an impulse across N: at most mu times the normal impulse, and at most what stops the
 * sliding. Balls do not spin.
 *
 * <p>Simultaneous impacts happen one after the other, in the order in which the balls met, until none is left. So in a
 * row of equal balls the impact passes from ball to ball. Balls that would separate no faster than the rest
 * speed do not bounce. Slow balls, and balls that still approach after many impacts, are stopped together.
 *
 * <p>Balls that are pressed on each other then stay in contact: {@link RigidConstraints} has their forces, without
 * friction. Such a contact ends where its force would become negative.
 */
public final class Collisions implements EventRule {
    private static final int STRIDE = Particles.STRIDE;
    /** The largest gap of balls that begin in contact, relative to 1 m plus the distance from the origin. */
    private static final double TOUCHING = 1e-9;
    /**
     * The same at an impact, where only round-off counts: with 1e-9, a row of balls that fits exactly between two walls
     * stuck in steps of nanoseconds.
     */
    private static final double ROUND_OFF = 1e-13;
    /** The largest number of simultaneous impacts for each contact; with r = 0.5, speeds fall to a millionth in 20. */
    private static final int MOST_IMPACTS = 100;

    private final ExactImpacts impacts;
    private final ParticleSystem system;
    private final Particles particles;
    private final BallContacts touching;
    private final Balls balls;
    private final double largest;
    private final NeighbourGrid grid = new NeighbourGrid();
    private final FirstCrossing crossing = new FirstCrossing();

    /**
     * The law of impact.
     *
     * @param radii       the radius of each particle (m), positive
     * @param restitution r, 0 ... 1
     * @param friction    mu, 0 or more
     * @param restSpeed   balls that would separate more slowly than this stay in contact (m/s), 0 or more
     */
    public record Balls(double[] radii, double restitution, double friction, double restSpeed) {
    }

    /** A pair of balls. */
    private interface Pair {
        void take(int i, int j);
    }

    /**
     * @param impacts     the impacts with surfaces
     * @param constraints the rods and wires, solved with these contacts; also holds the contacts of balls
     * @param balls       the law of impact
     */
    public Collisions(ExactImpacts impacts, RigidConstraints constraints, Balls balls) {
        this.impacts = impacts;
        system = impacts.system;
        particles = impacts.particles;
        touching = constraints.balls();
        this.balls = balls;
        largest = Arrays.stream(balls.radii).max().orElse(0);
    }

    @Override
    public String getName() {
        return "collisions";
    }

    /** {@inheritDoc} The largest overlap of balls, relative to their distance in contact. */
    @Override
    public Violation getViolation(ParticleSystem system) {
        double[] state = system.getOwnState();
        Violation[] worst = {Violation.NONE};
        findPairs(state, new double[particles.count()], (i, j) -> {
            double depth = -gap(state, i, j);
            worst[0] = depth <= Impacts.slack(state, i) ? worst[0] : worst[0].or(new Violation(depth / reach(i, j),
                    "'" + particles.id(i) + "' and '" + particles.id(j) + "' overlap by "
                    + Digits.few(depth) + " m"));
        });
        return worst[0];
    }

    /** Balls that begin in contact, and are pressed on each other, stay in contact from the start. */
    @Override
    public void start(ParticleSystem system) {
        settle(TOUCHING);
    }

    /** {@inheritDoc} Removes the solver's error that would let balls in contact drift, as {@link ExactImpacts} does. */
    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        touching.putTogether(system.getOwnState());
        return false;
    }

    @Override
    public void findEvents(Motion motion, List<Event> found) {
        double[] begin = motion.getStartState();
        if (touching.hasContacts()) {
            if (IntStream.range(touching.begin(), touching.end())       // a surface has struck or stopped a ball
                    .anyMatch(r -> Math.abs(separation(r, begin)) > slow(r, begin))) {
                found.add(new Event(motion.getStartTime(), false, () -> 0,
                        () -> settle(ROUND_OFF)));
                return;
            }
            if (push() < 0) {
                // just before the end: surfaces are only asked once the balls have parted
                found.add(new Event(Math.nextDown(motion.getEndTime()), true, this::push, this::release));
            }
        }
        double h = motion.getEndTime() - motion.getStartTime();
        double[] moves = new double[particles.count()];         // the farthest that each may get
        for (int i = 0; i < particles.count(); i++) {
            crossing.begin(begin, motion.getEndState(), h, i);
            for (int k = 3; k < 12; k += 3) {
                moves[i] = Math.max(moves[i], Vector3.at(crossing.points, k).minus(Vector3.at(begin, STRIDE * i))
                        .length());
            }
        }
        double size = ExactImpacts.DEEP * ExactImpacts.size(motion);
        findPairs(begin, moves, (i, j) -> findMeeting(motion, i, j, size, found));
    }

    /** Finds all pairs that are in reach, may move relative to each other and are not in contact. */
    private void findPairs(double[] state, double[] moves, Pair pair) {
        int n = particles.count();
        int[] near = new int[n];
        double farthest = Arrays.stream(moves).max().orElse(0);
        Set<List<Integer>> links = touching.findLinks();
        grid.build(state, n, (2 * largest + 2 * farthest) * (1 + TOUCHING) + TOUCHING);
        for (int i = 0; i < n; i++) {
            for (int k = grid.findLater(i, near) - 1; k >= 0; k--) {
                int j = near[k];
                if (gap(state, i, j) <= moves[i] + moves[j] + Impacts.slack(state, i)
                        && !(particles.isFixed(i) && particles.isFixed(j)) && !links.contains(List.of(i, j))) {
                    pair.take(i, j);
                }
            }
        }
    }

    /** Finds when two balls meet; as for surfaces, those that begin in contact have to go deeper than round-off. */
    private void findMeeting(Motion motion, int i, int j, double rounding, List<Event> found) {
        double[] begin = motion.getStartState();
        double gap = gap(begin, i, j);
        boolean begins = gap <= Impacts.slack(begin, i);
        double below = begins ? Math.max(0, rounding + ExactImpacts.DEEP * reach(i, j) - gap) : 0;
        double h = motion.getEndTime() - motion.getStartTime();
        crossing.begin(begin, motion.getEndState(), h, i);
        crossing.add(-1, begin, motion.getEndState(), h, j);
        double u = crossing.into(new Sphere(Vector3.ZERO, reach(i, j), false), below * (2 * reach(i, j) - below));
        if (!Double.isNaN(u)) {
            DoubleSupplier function = () -> {
                double above = gap(system.getOwnState(), i, j) + below;
                return begins ? Math.max(above, rate(system.getOwnState(), i, j)) : above;
            };
            found.add(ExactImpacts.meeting(motion, u, begins, function, () -> {
                touching.touch(i, j, reach(i, j));
                settle(ROUND_OFF);
            }));
        }
    }

    /**
     * Applies the impacts of balls in contact; contacts that do not push end. Balls that touch but for round-off and
     * are as slow as at rest take part: left out, a ball could bounce for ever in a gap of round-off size.
     *
     * @param near the largest gap, relative to 1 m plus the distance from the origin
     */
    private void settle(double near) {
        double[] state = system.getOwnState();
        findPairs(state, new double[particles.count()], (i, j) -> {
            if (gap(state, i, j) <= near / TOUCHING * Impacts.slack(state, i)
                    && Math.abs(rate(state, i, j)) <= balls.restSpeed) {
                touching.touch(i, j, reach(i, j));
            }
        });
        int r = findImpact(state);
        for (int left = MOST_IMPACTS * touching.end(); r >= 0 && left > 0; left--) {
            double leaving = -balls.restitution * separation(r, state);
            touching.strike(r, leaving > balls.restSpeed ? leaving : 0, balls.friction, state);
            r = findImpact(state);
        }
        touching.stop(state, true);
        BitSet parted = new BitSet();
        for (r = touching.end() - 1; r >= touching.begin(); r--) {
            if (separation(r, state) > slow(r, state)) {
                parted.set(touching.first(r));
                parted.set(touching.second(r));
                touching.part(r);
            }
        }
        parted.stream().forEach(i -> impacts.contacts.settle(i, false, state));     // on surfaces they still touch
        touching.stop(state, false);
        release();
        impacts.stickOthers();
        impacts.contacts.beginStep();                   // those that stick have stopped others
    }

    /** Ends contacts that do not push. */
    private void release() {
        impacts.contacts.beginStep();                   // the direction of friction, on which the forces depend
        touching.partWhereFree(system.getOwnState(), system.getTime(), impacts.forces());
    }

    /** The first contact whose balls approach each other faster than the rest speed; -1 for none. */
    private int findImpact(double[] state) {
        for (int r = touching.begin(); r < touching.end(); r++) {
            if (-separation(r, state) > slow(r, state)) {
                return r;
            }
        }
        return -1;
    }

    private double separation(int r, double[] state) {
        int i = touching.first(r);
        int j = touching.second(r);
        return apart(state, i, j, 0).dot(apart(state, i, j, 3)) / reach(i, j);
    }

    private double slow(int r, double[] state) {
        return Math.max(balls.restSpeed, Impacts.ROUNDING * (Impacts.velocity(state, touching.first(r)).norm1()
                + Impacts.velocity(state, touching.second(r)).norm1()));
    }

    private double push() {
        return touching.leastPush(system.getOwnState(), system.getTime(), impacts.forces());
    }

    private double reach(int i, int j) {
        return balls.radii[i] + balls.radii[j];
    }

    private double gap(double[] state, int i, int j) {
        return apart(state, i, j, 0).length() - reach(i, j);
    }

    private static double rate(double[] state, int i, int j) {
        return apart(state, i, j, 0).normalized().dot(apart(state, i, j, 3));
    }

    private static Vector3 apart(double[] state, int i, int j, int place) {
        return Vector3.at(state, STRIDE * j + place).minus(Vector3.at(state, STRIDE * i + place));
    }
}
