package particles.reactions;

import java.nio.DoubleBuffer;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import particles.law.Particles;
import particles.law.Scales;
import particles.law.Vector3;
import particles.reactions.NormalForces.Push;
import particles.reactions.Row.Kind;

/**
 * Answers questions of rules between steps: how large a normal force is, whether static friction can hold, and which
 * particles sliding friction may stop.
 */
public final class ContactQueries {
    private final Contacts contacts;
    private final ContactModes modes;
    private final GatherPhase gather;
    private final EvaluatePhase evaluate;
    private final SolvePhase solve;
    private final NormalForces normal;
    private List<?> asked = List.of();                  // the last question, of which the rest is kept
    private Optional<String> failure = Optional.empty();
    private Optional<StaticFriction> atRest = Optional.empty();

    ContactQueries(NormalForces normal) {
        this.normal = normal;
        solve = normal.solve;
        contacts = solve.contacts;
        modes = contacts.getModes();
        gather = solve.gather;
        evaluate = solve.evaluate;
    }

    /** Finds the forces of a block at rules' request; the last answer is kept, as rules ask for each particle. */
    private void ask(Block block, double[] state, double[] force, IntPredicate isHeld) {
        BitSet held = GatherPhase.where(block, isHeld);
        if (!asked.equals(question(block, held, state, force))) {
            gather.gather(block, held, true);
            failure = solve.solveForces(block, state, force);
            atRest = Optional.empty();
            asked = question(block, held, state.clone(), force.clone());
        }
    }

    private List<?> question(Block block, BitSet held, double[] state, double[] force) {
        return List.of(block, held, block.solutions, contacts.getStep(), modes.getChanges(), DoubleBuffer.wrap(state),
                DoubleBuffer.wrap(force));
    }

    /** The forces on the held particles of a block in the last question. */
    private StaticFriction forcesAtRest(Block block, double[] state, double[] force) {
        if (atRest.isEmpty()) {
            atRest = Optional.of(new StaticFriction(normal, block, state, solve.addUp(block, force)));
        }
        return atRest.get();
    }

    /**
     * The normal force of a surface on a particle that touches it.
     *
     * @param surface  the surface's index
     * @param particle the particle's index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return the normal force (N); if it is 0, minus the force that pulls the particle off
     */
    public double pressure(int surface, int particle, double[] state, double[] force) {
        double[] total = force;
        Block block = gather.of(particle);
        if (block.isJoined()) {
            evaluate.prepare(state, contacts.system.getTime());
            ask(block, state, force, modes::isSticking);
            if (failure.isPresent() && block.held.isEmpty()) {
                throw solve.failure(block, contacts.system.getTime(), failure.get());
            }
            if (!modes.isSticking(particle)) {
                Optional<Row> row = Row.find(block.rows, Kind.SURFACE, surface, particle);
                double push = row.isEmpty() ? 0 : solve.push(block, row.get(), force);
                return row.isEmpty() || push == row.get().force ? push : push / block.weight(particle);
            }
            total = forcesAtRest(block, state, force).getForces();
        }
        for (Push push : normal.find(particle, state, total, true)) {       // no stream, since each step asks
            if (push.surface() == contacts.getSurfaces().get(surface)) {
                return push.size() != 0 ? push.size() : -push.separation();
            }
        }
        return 0;
    }

    /** Whether a moving anchor drives a rod, so that friction cannot hold its other end; -1 for any end. */
    private boolean isDriven(Block block, int end, double[] state) {
        boolean driven = false;
        for (int r : block.members) {
            Row row = contacts.rows.get(r);
            driven |= (end < 0 || row.first == end || row.second == end) && row.isDraggedByAnchor(state,
                    evaluate.getAccelerations(), contacts.particles.getInverseMasses());
        }
        return driven;
    }

    /**
     * The margin by which static friction can hold a particle.
     *
     * @param particle its index
     * @param state    the particles' state
     * @param force    the total force of all effects (N)
     * @return the largest static friction minus the tangential force (N); negative if friction cannot hold it, or if
     *         nothing presses on it and no forces of rods and balls balance all others
     */
    public double holdMargin(int particle, double[] state, double[] force) {
        Block block = gather.of(particle);
        if (!block.isJoined()) {
            return normal.margin(particle, state, force);
        }
        evaluate.prepare(state, contacts.system.getTime());
        if (isDriven(block, particle, state)) {
            return -1;
        }
        ask(block, state, force, i -> i == particle || (modes.isSticking(i) || contacts.isSlow(i, state))
                && !isDriven(block, i, state));
        boolean moves = failure.isPresent()             // the rods' motion keeps it from standing still
                || block.left > Tolerances.STANDSTILL && isDriven(block, -1, state);
        return moves ? -1 : forcesAtRest(block, state, force).margin(particle);
    }

    /**
     * Whether Coulomb friction may turn so sharply within a time that a solver fails in one step: near a stop its
     * direction turns as fast as the velocity's, however slow that is.
     *
     * @param time the length of time from now (s)
     * @return whether the forces could stop any sliding particle within that time
     */
    public boolean mayStopWithin(double time) {
        double[] force = new double[contacts.system.getStateSize()];
        contacts.system.addUpEffects(contacts.system.getOwnState(), contacts.system.getTime(), force);
        return !findStopping(time, () -> force).isEmpty();
    }

    /**
     * Finds the sliding particles that the forces could stop; a loop, since each step asks.
     *
     * @param time   the length of time from now (s)
     * @param forces the total force of all effects (N), evaluated only if a particle slides with Coulomb friction
     * @return the particles
     */
    public BitSet findStopping(double time, Supplier<double[]> forces) {
        BitSet stops = new BitSet();
        double[] state = contacts.system.getOwnState();
        for (int i = 0; i < modes.end(); i++) {
            double rubbing = modes.isSticking(i) ? 0 : contacts.largest(i, f -> f.ofCoulomb(1));
            if (rubbing > 0) {
                double speed = Vector3.at(state, Particles.STRIDE * i + 3).length();
                double pull = Vector3.at(forces.get(), Particles.STRIDE * i + 3).length() / contacts.particles.mass(i);
                double sharpness = contacts.scalesOf(i).map(Scales::sharpness).orElse(1.0);
                stops.set(i, speed <= Tolerances.STOPS * time * (1 + rubbing * sharpness) * pull);
            }
        }
        return stops;
    }

    /**
     * How long sliding friction takes to stop a particle that is not coupled.
     *
     * @param i     its index
     * @param state the particles' state
     * @param force the total force of all effects (N)
     * @return the time (s); infinite if it does not slow down
     */
    public double stoppingTime(int i, double[] state, double[] force) {
        Vector3 velocity = Vector3.at(state, Particles.STRIDE * i + 3);
        double speed = velocity.length();
        if (speed == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double slowing = -Vector3.at(force, Particles.STRIDE * i + 3).dot(velocity) / speed;
        Push[] pushes = normal.find(i, state, force, true);
        double factor = normal.skin(i, state, pushes).stretch(velocity).length() / speed;
        for (Push push : pushes) {
            slowing += factor * push.surface().friction().ofCoulomb(push.size());
        }
        return slowing > 0 ? contacts.particles.mass(i) * speed / slowing : Double.POSITIVE_INFINITY;
    }
}
