package particles.reactions;

/**
 * All tolerances of contacts, rods and impacts: what counts as 0, and which errors mean no solution. Lengths are
 * relative to 1 m plus the distance from the origin, since a place far from it is rounded more coarsely.
 */
public final class Tolerances {

    // Places and times

    /** Surfaces and balls this near each other touch (relative length): round-off moves them a thousandth of it. */
    public static final double TOUCHING = 1e-9;
    /** Round-off of a place (relative length). */
    public static final double PLACE = 1e-13;
    /** A path from a surface may dip this deep by round-off of stages and forces (relative to the motion). */
    public static final double DEEP = 0x1p-48;
    /** Target for the errors of rods, wires and their velocities (relative to their length or speed): less is noise. */
    static final double LENGTH = 1e-15;
    /** Accepted error of nearly singular rods and wires, where round-off is larger (relative to their length). */
    static final double SINGULAR_LENGTH = 1e-9;
    /** A particle may slide this much too far in the step in which it stops (relative length): it cannot be seen. */
    public static final double FAR = 1e-4;
    /** Impacts are at one moment if their times differ by less than this fraction of the step. */
    public static final double AT_ONCE = 1e-9;
    /** The largest error of an event's time, in ulps of the clock. */
    public static final int CLOCK = 4;
    /** Births within this fraction of a step after its end happen at the end. */
    public static final double BIRTH = 1e-6;

    // Speeds

    /** Round-off of a few operations, relative to their largest term: of speeds at an impact, of distances. */
    public static final double ROUNDING = 1e-12;
    /** The largest speed that counts as standstill (m/s). */
    static final double STANDSTILL = 1e-9;
    /** A speed has no reliable direction below this, relative to the speed at the step's beginning. */
    static final double NO_DIRECTION = 1e-6;
    /** Friction has stopped a particle below this part of its speed before: forces change a little in the step. */
    static final double ALMOST_STOPPED = 0.01;
    /** Safety factor for whether friction may stop a particle in a step: yoshida4 looks a third of a step ahead. */
    static final double STOPS = 4;
    /** An elastic particle rests below this part of the speed that it gains in a step: the loss is round-off. */
    public static final double ELASTIC = 1e-6;
    /** An elastic particle rests only where it would bounce this often in a step. */
    public static final double BOUNCES = 1000;

    // Directions

    /** A normal within this angle of the plane of others lies in it (rad). */
    static final double PARALLEL = 1e-6;
    /** What is left of a vector along surfaces is round-off below this, relative to the vector. */
    static final double ALONG = 1e-14;

    // Equations of forces: relative to the largest right side of a block

    /** A contact's pull, or its separation inwards, below this is round-off. */
    static final double PULL = 1e-10;
    /** The residual of good factors. */
    static final double RESIDUAL = 1e-12;
    /** The round-off of accelerations where all masses are equal; it grows with the ratio of masses. */
    static final double NOISE = 0x1p-49;
    /** Active contacts contradict each other above this residual: another set of contacts is tried. */
    static final double CONTRADICTION = 1e-9;
    /** Errors above this have no solution: rods contradict each other, contacts jam. Drift of rods stays below. */
    static final double NO_SOLUTION = 1e-4;
    /** How much the diagonal of slightly elastic contacts grows. */
    static final double SOFT = 1e-9;
    /**
     * Separations below this part of a block's largest acceleration are round-off, where balls touch: 1,000 times
     * {@link #PULL}, as a pile pushes harder than its balls fall.
     */
    static final double STILL = 1e-7;
    /**
     * Pivots below this fraction of a diagonal entry (by QR, of the largest entry of R) are round-off: rows within an
     * angle of 3e-6 of being dependent. With uneven masses independent rows can be at smaller angles, so the limit is
     * divided by their ratio.
     */
    static final double SINGULAR = 1e-11;
    /** The smallest such fraction, however much masses differ. */
    static final double MOST_SINGULAR = 1e-14;
    /** Where masses differ by more than this factor, the round-off of forces would move the lightest particles. */
    static final double UNEVEN = 1000;
    /** Where they differ by more than this, it hides which rows are dependent. */
    static final double MOST_UNEVEN = 1e12;

    // Static friction in a block: relative to all forces on a particle

    /** What may be left of the force on a particle that is held. */
    static final double HELD = 1e-6;
    /** The search ends when what is left on each particle changes by less than this fraction of it. */
    static final double PROGRESS = 1e-5;

    private Tolerances() {
    }
}
