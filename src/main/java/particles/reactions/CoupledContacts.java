package particles.reactions;

import java.util.Arrays;
import java.util.Optional;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.law.Particles;
import particles.reactions.contact.ContactModes.Mode;

/**
 * Contacts of particles on rods or wires: normal forces, friction and constraint forces are solved together, since each
 * depends on the others. A sticking particle does not move; its contact force balances all others.
 */
final class CoupledContacts {
    private static final int STRIDE = Particles.STRIDE;
    private static final String CONTRADICTORY = "they contradict each other: no forces can satisfy them all";

    private final ParticleSystem system;
    private final Particles particles;
    private final ConstraintRows rows;
    private final RestingContacts contacts;
    private final double feedback;
    private final JointSystem joint;
    private final StaticFrictionFeasibility holdSearch;
    private double[] accelerations = {};
    private double[] total = {};                        // forces including those of rods and wires
    private double[] queryState = {};                   // the state of the last query
    private double[] queryForce = {};
    private double[] queryLambda = {};
    private double left;                                // the residual of the last solution, relative to accelerations
    private int queryChanges;
    private int[] queryMembers = {};

    CoupledContacts(ParticleSystem system, ConstraintRows rows, RestingContacts contacts, double feedback) {
        this.system = system;
        this.particles = system.getParticles();
        this.rows = rows;
        this.contacts = contacts;
        this.feedback = feedback;
        joint = new JointSystem(rows, particles, contacts);
        holdSearch = new StaticFrictionFeasibility(rows, contacts);
    }

    /**
     * Solves a linkage if any of its particles touches a surface. The rows must have been evaluated.
     *
     * @param force  the forces of all effects (N)
     * @param lambda receives the forces of rods and wires, by row
     * @return false if no particle touches anything; then nothing is done
     * @throws SimulationException if no forces satisfy all constraints, though no particle sticks; those that stick a
     *         rule releases at the end of the motion
     */
    boolean solve(Linkage linkage, double[] state, double time, double[] force, double[] lambda) {
        queryMembers = new int[0];
        if (!joint.take(linkage, state)) {
            return false;
        }
        Optional<String> failure = find(linkage, state, time, force, lambda);
        if (failure.isPresent() && !(failure.get().equals(CONTRADICTORY) && joint.isAnySticking())) {
            throw failure(linkage, time, failure.get());
        }
        return true;
    }

    /** Finds all forces for the current linkage; returns the reason if there are none. */
    private Optional<String> find(Linkage linkage, double[] state, double time, double[] force, double[] lambda) {
        boolean aboutToMove = joint.touching.isAnyAboutToMove(state);
        if (aboutToMove) {                              // the solution without friction shows the direction
            Optional<String> failure = solveOnce(linkage, time, force, lambda);
            if (failure.isPresent()) {
                return failure;
            }
            addUp(linkage, force, lambda);
        }
        for (int k = 0; k < joint.touching.count; k++) {
            double share = aboutToMove ? joint.touching.share(k, joint.solution, joint.constraintRows()) : 1;
            joint.touching.findSlip(k, aboutToMove ? push(k) : 1, share, aboutToMove ? total : force, state);
        }
        return solveOnce(linkage, time, force, lambda);
    }

    private double push(int k) {
        return joint.solution[joint.constraintRows() + k];
    }

    private Optional<String> solveOnce(Linkage linkage, double time, double[] force, double[] lambda) {
        joint.assemble();
        double scale = putRight(linkage, time, force);
        if (!joint.solve(!contacts.response().holdsOn(), 0)) {
            return Optional.of("no contact forces keep all particles out: friction jams");
        }
        for (int r = 0; r < joint.constraintRows(); r++) {
            lambda[joint.member(r)] = joint.solution[r];
        }
        left = joint.left() / scale;
        return left > RigidConstraints.CONTRADICTION ? Optional.of(CONTRADICTORY) : Optional.empty();
    }

    private SimulationException failure(Linkage linkage, double time, String reason) {
        int particle = linkage.particles()[0];
        return new SimulationException(time, particle, "rods, wires and contacts connected to particle '"
                + particles.id(particle) + "' at t = " + time + " s: " + reason, null);
    }

    /**
     * b = -(J W F + J' v) - k_s C - k_d C', with C the distance for contacts; returns the largest acceleration in b.
     */
    private double putRight(Linkage linkage, double time, double[] force) {
        system.putAnchorAccelerations(time, accelerations(force));
        double scale = 0;
        for (int i : linkage.particles()) {
            for (int f = STRIDE * i + 3; f < STRIDE * (i + 1); f++) {
                accelerations[f] = joint.mobility[i] * force[f];
                scale = Math.max(scale, Math.abs(force[f] * particles.getInverseMasses()[i]));
            }
        }
        int n = joint.constraintRows();
        for (int r = 0; r < n; r++) {
            int row = joint.member(r);
            joint.right[r] = joint.isIdle(r) ? 0 : -(rows.times(row, accelerations, 3) + rows.bend[row])
                    - feedback * feedback * rows.value[row] - 2 * feedback * rows.rate[row];
        }
        ContactRows touching = joint.touching;
        for (int k = 0; k < touching.count; k++) {
            joint.right[n + k] = -(touching.times(k, accelerations, 3) + touching.bend[k])
                    - feedback * feedback * touching.value[k] - 2 * feedback * touching.rate[k];
        }
        for (int r = 0; r < joint.size(); r++) {
            scale = Math.max(scale, Math.abs(joint.right[r]));
        }
        return scale;
    }

    private double[] accelerations(double[] like) {
        accelerations = accelerations.length < like.length ? new double[like.length] : accelerations;
        return accelerations;
    }

    /** Adds the forces found by {@link #solve}. */
    void addForces(Linkage linkage, double[] force, double[] lambda) {
        addReactions(linkage, lambda, force);
        for (int i : linkage.particles()) {
            if (joint.mobility[i] == 0) {
                Arrays.fill(force, STRIDE * i + 3, STRIDE * (i + 1), 0.0);
            }
        }
    }

    private void addReactions(Linkage linkage, double[] lambda, double[] force) {
        for (int row : linkage.members()) {
            rows.addForce(row, lambda[row], force);
        }
        for (int k = 0; k < joint.touching.count; k++) {
            joint.touching.addForce(k, push(k), force);
        }
    }

    /** The power of the contact forces found by {@link #solve} (W). */
    double power(double[] state) {
        double power = 0;
        ContactRows touching = joint.touching;
        for (int k = 0; k < touching.count; k++) {
            int v = STRIDE * touching.particle[k] + 3;
            for (int c = 0; c < 3; c++) {
                power += push(k) * (touching.normal[3 * k + c] - touching.slip[3 * k + c]) * state[v + c];
            }
        }
        return power;
    }

    /** Sums the forces of effects, rods, wires and sliding contacts. */
    private void addUp(Linkage linkage, double[] force, double[] lambda) {
        total = total.length == force.length ? total : new double[force.length];
        System.arraycopy(force, 0, total, 0, force.length);
        addReactions(linkage, lambda, total);
    }

    /** As {@link RestingContacts#pressure}. */
    double pressure(Linkage linkage, int surface, int particle, double[] state, double[] force, double[] lambda) {
        if (!isSameQuery(linkage, state, force)) {
            rows.evaluate(state);
            if (!solve(linkage, state, system.getTime(), force, lambda)) {
                return 0;
            }
            queryMembers = linkage.members();
            queryState = state.clone();
            queryForce = force.clone();
            queryLambda = lambda.clone();
            queryChanges = contacts.getModes().changes();
        }
        if (contacts.getModes().isSticking(particle)) {
            return contacts.response().pressure(surface, particle, state,
                    forcesAtRest(linkage, state, force, queryLambda));
        }
        for (int k = 0; k < joint.touching.count; k++) {
            if (joint.touching.particle[k] == particle && joint.touching.surface[k] == surface) {
                return push(k) != 0 ? push(k) : -joint.separation(k) * particles.mass(particle);
            }
        }
        return 0;
    }

    private boolean isSameQuery(Linkage linkage, double[] state, double[] force) {
        return queryMembers == linkage.members() && queryChanges == contacts.getModes().changes()
                && Arrays.equals(queryState, state) && Arrays.equals(queryForce, force);
    }

    /** As {@link RestingContacts#holdMargin}. */
    double holdMargin(Linkage linkage, int particle, double[] state, double[] force, double[] lambda) {
        queryMembers = new int[0];
        rows.evaluate(state);
        system.putAnchorAccelerations(system.getTime(), accelerations(state));
        if (linkage.isDriven(particle, state, accelerations)) {
            return -1;
        }
        joint.take(linkage, state, i -> i == particle || (contacts.getModes().isSticking(i)
                || contacts.isSlow(i, state)) && !linkage.isDriven(i, state, accelerations));
        if (find(linkage, state, system.getTime(), force, lambda).isPresent()
                || left > RestingContacts.ROUNDING && linkage.isDriven(-1, state, accelerations)) {
            // the rods' motion keeps it from standing still, which is not a failure
            return -1;
        }
        return contacts.response().holdMargin(particle, state, forcesAtRest(linkage, state, force, lambda));
    }

    private double[] forcesAtRest(Linkage linkage, double[] state, double[] force, double[] lambda) {
        addUp(linkage, force, lambda);
        holdSearch.run(linkage, joint, state, total);
        return total;
    }

    /** As {@link RestingContacts#canPush}: some impulses of the linkage move the particle away from the surface. */
    boolean canPush(Linkage linkage, int surface, int particle, double[] state) {
        takeForImpact(linkage, surface, particle, state);
        joint.right[joint.constraintRows()] = 1;
        return joint.solve(true, 1) && Math.abs(joint.separation(0)) < RigidConstraints.CONTRADICTION;
    }

    /** The first contact is that of the impact. */
    private void takeForImpact(Linkage linkage, int surface, int particle, double[] state) {
        queryMembers = new int[0];
        rows.evaluate(state);
        joint.takeForImpact(linkage, state, surface, particle);
        joint.assemble();
    }

    /** As {@link RestingContacts#strike}. */
    void strike(Linkage linkage, int surface, int particle, double leaving, double[] state) {
        takeForImpact(linkage, surface, particle, state);
        int n = joint.constraintRows();
        for (int r = 0; r < n; r++) {
            joint.right[r] = -rows.rate[joint.member(r)];
        }
        for (int k = 0; k < joint.touching.count; k++) {
            joint.right[n + k] = (k == 0 ? leaving : 0) - joint.touching.rate[k];
        }
        int v = STRIDE * particle + 3;
        double fast = leaving + Math.abs(state[v]) + Math.abs(state[v + 1]) + Math.abs(state[v + 2]);
        if (!joint.solve(true, 1) || Math.abs(joint.separation(0)) > RigidConstraints.CONTRADICTION * fast) {
            throw failure(linkage, system.getTime(), "no impulses keep all particles out");
        }
        joint.move(state, 3);
        for (int i : linkage.particles()) {
            contacts.getModes().setWhereTouching(i, Mode.SLIDING);
        }
        for (int k = 1; k < joint.touching.count; k++) {
            if (joint.separation(k) > contacts.getSurfaces().get(joint.touching.surface[k]).restSpeed()) {
                contacts.getModes().set(joint.touching.surface[k], joint.touching.particle[k], Mode.FREE);
            }
        }
    }

    /**
     * Projects positions or velocities onto rods, wires and touched surfaces. The rows must have been evaluated.
     *
     * @param place 0 for positions, 3 for velocities
     * @return false if the linkage touches nothing; then nothing is done
     */
    boolean correct(Linkage linkage, double[] state, int place) {
        queryMembers = new int[0];
        if (!joint.take(linkage, state)) {
            return false;
        }
        joint.assemble();
        int n = joint.constraintRows();
        for (int r = 0; r < joint.size(); r++) {
            double off = r < n ? (place == 0 ? rows.value : rows.rate)[joint.member(r)]
                    : (place == 0 ? joint.touching.value : joint.touching.rate)[r - n];
            joint.right[r] = r < n && joint.isIdle(r) ? 0 : -off;
        }
        joint.solve(false, joint.touching.count);
        joint.move(state, place);
        return true;
    }
}
