package particles.reactions;

import deSolvers.ForceDerivatives;
import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Scales;
import particles.law.Vector3;
import particles.law.Violation;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface.Friction;
import particles.reactions.NormalForces.Push;

/**
 * The contact force on particles that rest on surfaces, the slides' "Particle/Plane Contact": for N . F &ge; 0 it is 0;
 * otherwise the normal force is lambda = -(N . F), and friction is lambda times the friction law. Several surfaces on
 * one particle share the load. A particle on a rod or wire, or in contact with a ball, is <i>coupled</i>: it and all
 * that it is connected to, its linkage, are solved together by {@link RigidConstraints}. On a sphere the normal force
 * differs by the centripetal term m v_t&sup2;/R: less on a ball, more in a hollow.
 *
 * <p>Whether a particle touches a surface, and whether it slides or sticks there, does not change within a step: {@code
 * particles.rules.ClampedImpacts} decides it between steps, {@code ExactImpacts} at events that end one piece of
 * motion. So the force is a smooth function of the state while a solver works.
 *
 * <p>The forces on particles that are not coupled are added in one loop over arrays. On one surface the slides' closed
 * form needs no system of equations: a cloth of 900 particles draped over a ball has hundreds of such contacts, each of
 * which should cost about as much as a spring, some nanoseconds. Particles on several surfaces are {@link Block}s.
 */
public final class RestingContacts implements Reaction {
    private static final int MOST_ITERATIONS = 100;

    /** In place of a surface: the particle sticks, so that the total force on it is 0. */
    private static final int STICKS = -1;
    /** In place of a surface: the particle slides on several. */
    private static final int SEVERAL = -2;
    private static final double[] NONE = new double[9];

    private final Contacts contacts;
    private final ContactModes modes;
    private final Particles particles;
    final ApplyPhase apply;
    private final GatherPhase gather;
    private final EvaluatePhase evaluate;
    private final NormalForces normal;
    private final BlockImpacts impacts;
    private final ContactQueries queries;
    private int[] touching = {};
    private int[] surface = {};                         // that each of these particles slides on
    private int count;
    private int gatheredAt = -1;                        // the modes' and the rows' counts of changes
    private double[] total = {};

    /**
     * @param system   the system of the particles
     * @param surfaces the surfaces
     */
    public RestingContacts(ParticleSystem system, List<ContactSurface> surfaces) {
        contacts = new Contacts(system, surfaces);
        modes = contacts.getModes();
        particles = contacts.particles;
        SolvePhase solve = new SolvePhase(contacts);
        gather = solve.gather;
        evaluate = solve.evaluate;
        apply = new ApplyPhase(solve);
        normal = new NormalForces(solve);
        impacts = new BlockImpacts(apply);
        queries = new ContactQueries(normal);
    }

    /** @return who touches what, and how */
    public Contacts getContacts() {
        return contacts;
    }

    /** @return the impacts of these contacts */
    public BlockImpacts getImpacts() {
        return impacts;
    }

    /** @return what is asked of these contacts between steps */
    public ContactQueries getQueries() {
        return queries;
    }

    /**
     * @param particle its index
     * @return whether it is coupled to others, which then feel an impulse on it
     */
    public boolean isCoupled(int particle) {
        return gather.isCoupled(particle);
    }

    /**
     * Corrects the velocities of a particle or its linkage after one of them was changed: no rod is stretched, no
     * touched surface is entered or left, and sticking particles stay.
     *
     * @param particle the particle, or one of the linkage
     * @param balls    whether balls in contact may not separate either
     * @param state    the state, in which velocities are changed
     */
    public void settle(int particle, boolean balls, double[] state) {
        if (gather.isCoupled(particle) || !modes.isSticking(particle)) {    // else held, and its contacts have no rows
            apply.correct(gather.of(particle), state, 3, false, balls);
        }
    }

    /** Projects the positions and velocities of all linkages onto their rods, wires and touched surfaces. */
    public void putBack() {
        apply.project(contacts.system.getOwnState(), contacts.system.getTime());
    }

    @Override
    public String getName() {
        return "contact";
    }

    @Override
    public boolean isActive() {
        return modes.isAnyTouching();
    }

    @Override
    public boolean dependsOnVelocity() {
        return contacts.getSurfaces().stream().anyMatch(surface -> surface.friction().law() != Friction.Law.NONE);
    }

    @Override
    public boolean hasForceDerivatives() {
        return true;
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        addAll(state, time, force);
    }

    private void gatherTouching() {
        int changes = modes.getChanges() + contacts.getRowChanges();
        if (gatheredAt == changes) {
            return;
        }
        gatheredAt = changes;
        count = 0;
        if (touching.length < modes.end()) {
            touching = new int[modes.end()];
            surface = new int[modes.end()];
        }
        for (int i = 0; i < modes.end(); i++) {
            if (modes.isTouching(i) && !particles.isFixed(i) && !gather.isCoupled(i)) {
                touching[count] = i;
                int only = modes.only(i);
                surface[count++] = modes.isSticking(i) ? STICKS : only >= 0 ? only : SEVERAL;
            }
        }
    }

    /** Adds the contact forces to those of all effects (N); returns the power of friction (W). */
    private double addAll(double[] state, double time, double[] force) {
        gatherTouching();
        evaluate.prepare(state, time);
        double power = 0;
        for (int k = 0; k < count; k++) {
            power += add(k, state, time, force);
        }
        return power;
    }

    private double add(int k, double[] state, double time, double[] force) {
        int i = touching[k];
        if (surface[k] == SEVERAL) {
            return apply.addForces(gather.of(i), state, time, force, row -> row.frictionPower(state));
        }
        if (surface[k] == STICKS) {
            Arrays.fill(force, Particles.STRIDE * i + 3, Particles.STRIDE * (i + 1), 0.0);
            return 0;
        }
        return evaluate.sliding.addAlone(i, particles.mass(i), contacts.getSurfaces().get(surface[k]),
                !contacts.isHolding(), state, force);
    }

    @Override
    public void addForceDerivatives(double[] state, double time, double[] force, ForceDerivatives derivatives) {
        gatherTouching();
        evaluate.prepare(state, time);
        double[][] matrices = new double[4][9];         // by force, place, velocity and the neighbour's place
        for (int k = 0; k < count; k++) {
            int i = touching[k];
            Optional<Scales> scales = contacts.scalesOf(i);
            int end = scales.map(s -> s.head() == i ? 1 : -1).orElse(0);     // how its place enters the body's axis
            ContactDerivative derivative = new ContactDerivative(contacts, i, particles.mass(i), state,
                    Vector3.at(force, Particles.STRIDE * i + 3), pushes(k, state, force));
            for (int c = 0; c < 3; c++) {
                Vector3 unit = new Vector3(c == 0 ? 1 : 0, c == 1 ? 1 : 0, c == 2 ? 1 : 0);
                Vector3 body = unit.times(end);
                Vector3[] columns = {derivative.change(unit, Vector3.ZERO, Vector3.ZERO, Vector3.ZERO),
                    derivative.change(Vector3.ZERO, unit, Vector3.ZERO, body),
                    derivative.change(Vector3.ZERO, Vector3.ZERO, unit, Vector3.ZERO),
                    derivative.change(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO, body.times(-1))};
                for (int m = 0; m < columns.length; m++) {
                    Vector3 column = surface[k] == STICKS ? Vector3.ZERO : columns[m];
                    matrices[m][c] = column.x();
                    matrices[m][3 + c] = column.y();
                    matrices[m][6 + c] = column.z();
                }
            }
            derivatives.transformRow(i, matrices[0]);
            derivatives.add(i, i, matrices[1], matrices[2]);
            scales.ifPresent(s -> derivatives.add(i, s.tail() + s.head() - i, matrices[3], NONE));
        }
    }

    /** The normal forces on a particle that act now. */
    private Push[] pushes(int k, double[] state, double[] force) {
        if (surface[k] == STICKS) {
            return new Push[0];
        }
        Push[] found = normal.find(touching[k], state, force, !contacts.isHolding());
        boolean last = found.length == 1 && contacts.isHolding();
        return Arrays.stream(found).filter(push -> last || push.size() != 0).toArray(Push[]::new);
    }

    @Override
    public double getPower(double[] state, double time, double[] force) {
        total = total.length == force.length ? total : new double[force.length];
        System.arraycopy(force, 0, total, 0, force.length);
        return apply.power(state, time, force, row -> row.frictionPower(state)) + addAll(state, time, total);
    }

    @Override
    public Violation getViolation(double[] state, double since) {
        List<ContactSurface> surfaces = contacts.getSurfaces();
        double worst = 0;
        int farthest = -1;
        ContactSurface from = null;
        for (int i = 0; i < particles.count(); i++) {
            for (int p = 0; p < surfaces.size(); p++) {
                ContactSurface surface = surfaces.get(p);
                double distance = surface.distance(state, i);
                double off = particles.isFixed(i) || particles.birthTime(i) > since
                        || modes.get(p, i) == Mode.FREE && distance > 0 ? 0 : Math.abs(distance);
                double part = off * (surface.obstacle().isFlat() ? 1 : surface.curvature(state, i));
                if (part > worst) {
                    worst = part;
                    farthest = i;
                    from = surface;
                }
            }
        }
        return from == null ? Violation.NONE : new Violation(worst, "'" + particles.id(farthest) + "' is "
                + Digits.few(Math.abs(from.distance(state, farthest))) + " m off '" + from.name() + "'");
    }

    @Override
    public void reindex(int[] newIndex) {
        contacts.reindex(newIndex);
    }

    /**
     * Puts a particle on all the surfaces that it touches, with no velocity across them: all are solved together, since
     * to correct one may push the particle into another. Does nothing for a coupled particle.
     *
     * @param particle its index
     * @param state    the state, in which its position and velocity are changed
     */
    public void putOnSurfaces(int particle, double[] state) {
        Block block = gather.of(particle);
        double near = Tolerances.PLACE * (1 + Vector3.at(state, Particles.STRIDE * particle).norm1());
        double off = Double.POSITIVE_INFINITY;
        for (int k = 0; k < MOST_ITERATIONS && off > near && !block.isJoined(); k++) {
            apply.correct(block, state, 0, false, true);
            off = Arrays.stream(block.rows).mapToDouble(row -> Math.abs(row.value)).max().orElse(0);
            settle(particle, false, state);
        }
    }
}
