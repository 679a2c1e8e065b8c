package particles.rules;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import particles.EventRule;
import particles.Motion;
import particles.ParticleSystem;
import particles.effects.neighbours.NeighbourGrid;
import particles.law.Particles;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.law.Violation;
import particles.reactions.BallContacts;
import particles.reactions.ContactSurface.Bounce;
import particles.reactions.RigidConstraints;
import particles.reactions.Tolerances;
import particles.rules.ExactImpacts.Gap;

/**
 * Hard spheres: particles are balls that bounce off each other. Impacts are located like those with surfaces, see
 * {@link ExactImpacts}. With the unit vector N along the line of centres, the speed of approach v becomes the speed of
 * separation r v, and friction is an impulse across N: at most mu times the normal impulse, and at most what stops the
 * sliding. Balls do not spin.
 *
 * <p>All impacts at one moment are answered together, with those on surfaces, see {@link
 * particles.reactions.BlockImpacts}. Balls that would separate no faster than the rest speed do not bounce.
 *
 * <p>Balls that are pressed on each other then stay in contact: {@link RigidConstraints} has their forces, without
 * friction. Such a contact ends where its force would become negative.
 */
public final class Collisions implements EventRule {
    private static final int STRIDE = Particles.STRIDE;

    private final ExactImpacts impacts;
    private final ParticleSystem system;
    private final Particles particles;
    private final BallContacts touching;
    private final Balls balls;
    private final NeighbourGrid grid = new NeighbourGrid();
    private double fast;                                // of all balls, at the last impact (m/s)
    private final FirstCrossing crossing = new FirstCrossing();

    /**
     * Hard balls.
     *
     * @param radius the radius of those that are born during the run (m), positive; others have their own
     * @param bounce the law of impact
     */
    public record Balls(double radius, Bounce bounce) {
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
        impacts.join(this);
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
        findTouching(Tolerances.TOUCHING);
        impacts.answer(-1, -1);
    }

    @Override
    public void beforeStep(ParticleSystem system, double deltaT) {
        touching.beginStep();
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
            if (touching.isAnyMoving(begin, slow())) {  // a surface has struck or stopped a ball
                found.add(new Event(motion.getStartTime(), false, () -> 0, () -> impacts.answer(-1, -1)));
                return;
            }
            if (push() < 0) {
                // just before the end: surfaces are only asked once the balls have parted
                found.add(new Event(Math.nextDown(motion.getEndTime()), true, this::push,
                        () -> release(push())));
            }
        }
        double h = motion.getEndTime() - motion.getStartTime();
        double[] moves = new double[particles.count()];         // the farthest that each may get
        for (int i = 0; i < particles.count(); i++) {
            crossing.begin(begin, motion.getEndState(), h, i);
            moves[i] = crossing.reach();
        }
        double size = ExactImpacts.size(motion);
        findPairs(begin, moves, (i, j) -> findMeeting(motion, i, j, size, found));
    }

    /** Finds all pairs that are in reach, may move relative to each other and are not in contact. */
    private void findPairs(double[] state, double[] moves, Pair pair) {
        int n = particles.count();
        int[] near = new int[n];
        double farthest = Arrays.stream(moves).max().orElse(0);
        double largest = 0;
        for (int i = 0; i < n; i++) {
            largest = Math.max(largest, particles.radius(i));
        }
        Set<List<Integer>> links = touching.findLinks();
        grid.build(state, n, (2 * largest + 2 * farthest) * (1 + Tolerances.TOUCHING) + Tolerances.TOUCHING);
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

    private void findMeeting(Motion motion, int i, int j, double size, List<Event> found) {
        double[] begin = motion.getStartState();
        double h = motion.getEndTime() - motion.getStartTime();
        crossing.begin(begin, motion.getEndState(), h, i);
        crossing.add(-1, begin, motion.getEndState(), h, j);
        Gap gap = new Gap(new Sphere(Vector3.ZERO, reach(i, j), false), 0, state -> gap(state, i, j),
                state -> rate(state, i, j));
        boolean begins = gap(begin, i, j) <= Impacts.slack(begin, i);
        double depth = begins ? Tolerances.DEEP * (size + reach(i, j)) : Double.NaN;
        ExactImpacts.findMeeting(motion, crossing, gap, depth, found, () -> {
            touching.touch(i, j, reach(i, j), balls.bounce);
            impacts.answer(-1, -1);
        });
    }

    /**
     * Notes the balls that touch at this moment: those that approach, and those as slow as at rest. Returns whether
     * there are any that had not been noted.
     */
    boolean findTouching() {
        return findTouching(0);
    }

    private boolean findTouching(double near) {
        double[] state = system.getOwnState();
        int before = touching.count();
        fast = 0;
        for (int i = 0; i < particles.count(); i++) {
            fast = Math.max(fast, Impacts.velocity(state, i).norm1());
        }
        findPairs(state, new double[particles.count()], (i, j) -> {
            if (gap(state, i, j) <= Math.max(near, impacts.moment(state, i) + impacts.moment(state, j))
                    && rate(state, i, j) <= slow()) {
                touching.touch(i, j, reach(i, j), balls.bounce);
            }
        });
        return touching.count() > before;
    }

    /** Ends the contacts of balls that separate; those that do not, and do not push, end too. */
    void settle() {
        double[] state = system.getOwnState();
        touching.stop(state, true);
        BitSet apart = touching.partWhereFast(state, Tolerances.ROUNDING * fast, slow());
        apart.stream().forEach(i -> impacts.resting.settle(i, false, state));     // on surfaces they still touch
        apart.stream().filter(i -> impacts.contacts.isSlow(i, state)).forEach(i -> impacts.stickIfSlow(i, fast));
        touching.stop(state, false);
        release(-Double.MIN_VALUE);
        impacts.stickOthers();
        impacts.contacts.beginStep();                   // those that stick have stopped others
    }

    /** Ends contacts that push no more than some force (N), which is 0 but for round-off. */
    private void release(double most) {
        impacts.contacts.beginStep();                   // the direction of friction, on which the forces depend
        touching.partWhereFree(system.getOwnState(), system.getTime(), impacts.forces(), most);
    }

    /** The speed below which balls do not separate: the rest speed, or round-off. */
    private double slow() {
        return Math.max(balls.bounce.restSpeed(), Tolerances.ROUNDING * fast);
    }

    private double push() {
        return touching.leastPush(system.getOwnState(), system.getTime(), impacts.forces());
    }

    private double reach(int i, int j) {
        return particles.radius(i) + particles.radius(j);
    }

    /** Whether a ball can be born at a place. */
    boolean hasRoom(Vector3 at) {
        double[] state = system.getOwnState();
        double least = balls.radius - Tolerances.PLACE * (1 + at.norm1());
        for (int i = 0; i < particles.count(); i++) {
            if (Vector3.at(state, STRIDE * i).minus(at).length() < particles.radius(i) + least) {
                return false;
            }
        }
        double[] place = {at.x(), at.y(), at.z()};
        return impacts.surfaces.stream().allMatch(surface -> surface.obstacle().distance(place, 0) >= least);
    }

    /** Makes a ball of a particle that was born. */
    void addBall(int particle) {
        particles.setRadius(particle, balls.radius);
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
