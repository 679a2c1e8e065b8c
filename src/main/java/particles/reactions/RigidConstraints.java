package particles.reactions;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleBiFunction;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Require;
import particles.law.Violation;
import particles.reactions.contact.ContactModes;
import particles.reactions.wires.Curve;
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

    private final ParticleSystem system;
    private final Particles particles;
    private final double feedback;
    private final ConstraintRows rows = new ConstraintRows();
    private final List<Block> joined = new ArrayList<>();
    private RestingContacts contacts;
    private BlockForces blocks;
    private Block[] blockOf = {};                       // by particle; null for none
    private boolean arranged;

    /**
     * @param system   the system of the particles
     * @param feedback alpha, the rate at which errors decay (1/s), 0 or more
     * @throws IllegalArgumentException if the rate is out of range
     */
    public RigidConstraints(ParticleSystem system, double feedback) {
        this.system = system;
        this.particles = system.getParticles();
        this.feedback = Require.notNegative("the feedback rate", feedback);
        contacts = new RestingContacts(system, List.of());
        blocks = new BlockForces(system, rows, contacts, feedback);
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
        rows.addRod(from, to, Require.positive("the length of a rod", length));
        arranged = false;
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
        rows.addBead(particle, wire);
        arranged = false;
    }

    /** Finds the blocks, once and after particles were removed. */
    private void arrange() {
        if (!arranged) {
            joined.clear();
            blockOf = new Block[particles.count()];
            for (int[] part : new RowGraph(rows, particles).parts()) {
                Block block = blocks.block(part);
                joined.add(block);
                for (int i : block.particles) {
                    blockOf[i] = block;
                }
            }
            arranged = true;
        }
    }

    @Override
    public String getName() {
        if (rows.getBeads() == 0) {
            return rows.getRods() == 0 ? "collisions" : "rods";
        }
        return rows.getRods() == 0 ? "wires" : "rods and wires";
    }

    @Override
    public boolean isActive() {
        return rows.count() > 0;
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
        arrange();
        blocks.prepare(state, time);
        for (int l = 0; l < joined.size(); l++) {
            blocks.solve(joined.get(l), state, time, force);
            blocks.addForces(joined.get(l), force);
        }
    }

    /** {@inheritDoc} Only moving anchors do work; energy changed by errors of the lengths counts as error. */
    @Override
    public double getPower(double[] state, double time, double[] force) {
        return sum(state, time, force, blocks::anchorPower);
    }

    /** The power of the contact forces of surfaces on connected particles (W). */
    double contactPower(double[] state, double time, double[] force) {
        return sum(state, time, force, blocks::frictionPower);
    }

    private double sum(double[] state, double time, double[] force, ToDoubleBiFunction<Block, double[]> power) {
        arrange();
        blocks.prepare(state, time);
        double sum = 0;
        for (Block block : joined) {
            blocks.solve(block, state, time, force);
            sum += power.applyAsDouble(block, state);
        }
        return sum;
    }

    /**
     * Solves these constraints and contacts with surfaces together where a particle has both. Each reports its own
     * power.
     *
     * @param contacts a reaction of the same system
     */
    public void solveWith(RestingContacts contacts) {
        this.contacts = contacts;
        blocks = new BlockForces(system, rows, contacts, feedback);
        arranged = false;
        contacts.joinTo(this, blocks, new ContactQueries(system, rows, contacts, blocks));
    }

    /** The contacts of balls, solved together with these constraints. */
    public BallContacts balls() {
        return new BallContacts(this, rows);
    }

    /** Finds the blocks again after a contact of balls began or ended. */
    void noteChange() {
        arranged = false;
        contacts.getModes().noteChange();
    }

    ContactModes getModes() {
        return contacts.getModes();
    }

    BlockForces getBlocks() {
        return blocks;
    }

    List<Block> getJoined() {
        arrange();
        return joined;
    }

    /** The block of a particle on a rod or wire, or in contact with a ball; none for others. */
    Optional<Block> block(int particle) {
        arrange();
        return particle < blockOf.length ? Optional.ofNullable(blockOf[particle]) : Optional.empty();
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
        arrange();
        ConstraintCorrection correction = new ConstraintCorrection(rows, joined, blocks);
        boolean moved = correction.positions(state, time);
        return correction.velocities(state) | moved;
    }

    @Override
    public Violation getViolation(double[] state, double since) {
        Violation worst = Violation.NONE;
        for (int r = 0; r < rows.getBeadRows(); r++) {
            double more = rows.distance(r, state) - rows.length(r);
            double part = Math.abs(more) / rows.length(r);
            if (part > worst.part()) {
                worst = new Violation(part, (rows.isContact(r) ? "the contact" : "the rod") + " from '"
                        + particles.id(rows.first(r)) + "' to '" + particles.id(rows.second(r)) + "' is "
                        + Digits.few(Math.abs(more)) + " m too " + (more > 0 ? "long" : "short"));
            }
        }
        rows.evaluate(state);
        for (int r = rows.getBeadRows(); r < rows.count(); r++) {
            double off = Math.abs(rows.value[r]);
            if (off > worst.part()) {
                worst = new Violation(off,
                        "'" + particles.id(rows.first(r)) + "' is " + Digits.few(off) + " m off its wire");
            }
        }
        return worst;
    }

    @Override
    public void reindex(int[] newIndex) {
        rows.reindex(newIndex);
        arranged = false;
    }

    @Override
    public int springCount() {
        return rows.getRods();
    }

    @Override
    public int from(int s) {
        return rows.first(s);
    }

    @Override
    public int to(int s) {
        return rows.second(s);
    }

    @Override
    public double restLength(int s) {
        return rows.length(s);
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
