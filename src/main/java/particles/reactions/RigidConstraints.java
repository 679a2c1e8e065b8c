package particles.reactions;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.List;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Require;
import particles.law.Violation;
import particles.reactions.Row.Kind;
import particles.view.SpringView;

/**
 * Constraint forces of rods, which keep distances, of wires, which keep beads on curves, and of {@link BallContacts},
 * which keep balls apart. With the constraints C(x) = 0, J their derivative and W the inverse masses, the forces
 * J<sup>T</sup> lambda satisfy
 * <pre>
 *   J W J^T lambda = -(J W F + J' v) - k_s C - k_d C',     k_s = alpha&sup2;, k_d = 2 alpha,
 * </pre>
 * so that C'' = -2 alpha C' - alpha&sup2; C: small errors of a solver's steps do not accumulate but decay, critically
 * damped, at the feedback rate alpha; where balls touch, after each step. (A. Witkin, "Constrained Dynamics", SIGGRAPH
 * course notes 1997; J. Baumgarte 1972.)
 *
 * <p>The choice of alpha: the solver has to be stable for the decay, alpha deltaT &lt; 2 for euler and midpoint, 2.78
 * for rk4. There is a stricter limit: at the stages inside a step C is off by O(deltaT&sup2;), because a straight line
 * leaves a circle, and the feedback turns that into a wrong acceleration of alpha&sup2; O(deltaT&sup2;). It is small
 * beside the true acceleration only if (alpha deltaT)&sup2; &lt;&lt; 1, and it falls with the solver's order only if
 * alpha does not grow with 1/deltaT. Measured for a pendulum of 1 m released at 90 degrees, rk4 at 0.01 s, the largest
 * error of the length in ten minutes:
 * <pre>
 *   alpha (1/s)   0       1      3      5      10     20     50     100    200    280
 *   error (m)     0.15    7e-7   5e-8   1e-7   4e-7   1e-6   8e-6   5e-5   7e-4   unstable
 * </pre>
 * With a smaller alpha errors accumulate faster than they decay; with a larger one the feedback itself causes them. The
 * default is 5 /s.
 *
 * <p>Only moving anchors do work through these forces. Any other change of energy is numerical error; it is of the
 * order of C and C'. The derivatives of the forces are not known: implicit solvers multiply with them by
 * differences, one evaluation each, and need some 30 in a step of a long chain.
 */
public final class RigidConstraints implements Reaction, SpringView {
    /** The default feedback rate alpha (1/s). */
    public static final double USUAL_FEEDBACK = 5;

    private final RestingContacts resting;
    private final Contacts contacts;
    private final Particles particles;
    private final List<Row> rows;

    /**
     * @param resting  the contacts of the same system, which are solved together with these constraints; each reports
     *                 its own power
     * @param feedback alpha, the rate at which errors decay (1/s), 0 or more
     * @throws IllegalArgumentException if the rate is out of range
     */
    public RigidConstraints(RestingContacts resting, double feedback) {
        this.resting = resting;
        contacts = resting.getContacts();
        contacts.setFeedback(Require.notNegative("the feedback rate", feedback));
        particles = contacts.particles;
        rows = contacts.rows;
    }

    /**
     * Constraints of a system without surfaces.
     *
     * @throws IllegalArgumentException if the rate is out of range
     */
    public RigidConstraints(ParticleSystem system, double feedback) {
        this(new RestingContacts(system, List.of()), feedback);
    }

    /**
     * Adds a rod.
     *
     * @param from   the index of the particle at its first end
     * @param to     the index of the particle at its second end
     * @param length the distance that it keeps (m), positive
     * @throws IllegalArgumentException if the length is out of range, or no end is free
     */
    public void addRod(int from, int to, double length) {
        if (from == to || particles.isFixed(from) && particles.isFixed(to)) {
            throw new IllegalArgumentException("a rod from '" + particles.id(from) + "' to '" + particles.id(to)
                    + "'; its ends have to be two particles, and one of them free");
        }
        contacts.addLink(Kind.ROD, from, to, Require.positive("the length of a rod", length));
    }

    /**
     * Threads a particle on a wire.
     *
     * @param particle its index
     * @param wire     the curve on which it stays
     * @throws IllegalArgumentException if the particle is fixed
     */
    public void addBead(int particle, Curve wire) {
        if (particles.isFixed(particle)) {
            throw new IllegalArgumentException("particle '" + particles.id(particle) + "' is fixed; a bead must"
                    + " be free to move");
        }
        contacts.addBead(particle, wire);
    }

    @Override
    public String getName() {
        if (contacts.begin(Kind.WIRE) == rows.size()) {
            return springCount() == 0 ? "collisions" : "rods";
        }
        return springCount() == 0 ? "wires" : "rods and wires";
    }

    @Override
    public boolean isActive() {
        return !rows.isEmpty();
    }

    @Override
    public boolean dependsOnVelocity() {
        return isActive();                              // the centripetal force does
    }

    @Override
    public boolean hasForceDerivatives() {
        return !isActive();
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        resting.apply.addForces(state, time, force);
    }

    @Override
    public double getLargestAcceleration() {
        return resting.apply.solve.gather.joined().stream().flatMap(block -> Arrays.stream(block.rows))
                .mapToDouble(row -> row.largestAcceleration(particles.getInverseMasses())).max().orElse(0);
    }

    /** {@inheritDoc} Only moving anchors do work; energy changed by errors of the lengths counts as error. */
    @Override
    public double getPower(double[] state, double time, double[] force) {
        return resting.apply.power(state, time, force,
                row -> -row.force * row.rateOfAnchors(state, particles.getInverseMasses()));
    }

    @Override
    public boolean transmitsWork() {
        return true;
    }

    /** The contacts of balls, solved together with these constraints. */
    public BallContacts balls() {
        return new BallContacts(resting.apply);
    }

    /**
     * Projects positions and velocities onto rods and wires, up to round-off.
     *
     * @param state the particles' state, which is changed
     * @param time  t (s), for messages
     * @return whether anything was changed
     * @throws SimulationException if no nearby positions satisfy the constraints
     */
    public boolean project(double[] state, double time) {
        return resting.apply.project(state, time);
    }

    /** {@inheritDoc} Errors of rods and contacts are relative to their lengths, those of wires to 1 m. */
    @Override
    public Violation getViolation(double[] state, double since) {
        Violation worst = Violation.NONE;
        for (Row row : rows) {
            row.evaluate(state);
            String from = "'" + particles.id(row.first) + "'";
            if (row.kind == Kind.WIRE) {
                double off = Math.abs(row.value);
                worst = worst.or(new Violation(off, from + " is " + Digits.few(off) + " m off its wire"));
            } else {
                double more = row.distance(state) - row.length;
                worst = worst.or(new Violation(Math.abs(more) / row.length,
                        (row.kind == Kind.BALLS ? "the contact" : "the rod") + " from " + from + " to '"
                                + particles.id(row.second) + "' is " + Digits.few(Math.abs(more)) + " m too "
                                + (more > 0 ? "long" : "short")));
            }
        }
        return worst;
    }

    @Override
    public void reindex(int[] newIndex) {
        contacts.reindexRows(newIndex);
    }

    @Override
    public int springCount() {
        return contacts.begin(Kind.BALLS);
    }

    @Override
    public int from(int s) {
        return rows.get(s).first;
    }

    @Override
    public int to(int s) {
        return rows.get(s).second;
    }

    @Override
    public double restLength(int s) {
        return rows.get(s).length;
    }

    /** {@inheritDoc} A rod's is infinite. */
    @Override
    public double stiffness(int s) {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public double damping(int s) {
        return 0;
    }
}
