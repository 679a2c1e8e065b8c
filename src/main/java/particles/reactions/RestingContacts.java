package particles.reactions;

import deSolvers.ForceDerivatives;
import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Scales;
import particles.law.Vector3;
import particles.law.Violation;
import particles.reactions.ContactModes.Mode;

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
 */
public final class RestingContacts implements Reaction {
    private static final int STRIDE = Particles.STRIDE;
    private static final int MOST_ITERATIONS = 100;

    private final ParticleSystem system;
    private final Particles particles;
    private final List<ContactSurface> surfaces;
    private final ContactModes modes;
    private final SlidingFriction sliding = new SlidingFriction();
    private Blocks blocks;
    private BlockImpacts impacts;
    private ContactQueries queries;
    private boolean holding;

    /**
     * @param system   the system of the particles
     * @param surfaces the surfaces
     */
    public RestingContacts(ParticleSystem system, List<ContactSurface> surfaces) {
        this.system = system;
        this.particles = system.getParticles();
        this.surfaces = List.copyOf(surfaces);
        modes = new ContactModes(particles, surfaces.size());
        join(new Rows(), 0);
    }

    /** @return the system of the particles */
    public ParticleSystem getSystem() {
        return system;
    }

    /** @return the surfaces, in the order of their indices in {@link #getModes} */
    public List<ContactSurface> getSurfaces() {
        return surfaces;
    }

    /** @return the contact mode of each particle at each surface, which rules change */
    public ContactModes getModes() {
        return modes;
    }

    /** @param scales by particle; null for those that have none */
    public void setScales(Scales... scales) {
        sliding.setScales(scales);
    }

    /**
     * Records the state at the beginning of a step. Coulomb friction would flip when sliding reverses; within a step it
     * is continued smoothly as if it had not, and the end of the step shows whether it did.
     */
    public void beginStep() {
        sliding.beginStep(system);
    }

    /**
     * Sets whether contact lasts until a rule ends it. Otherwise the normal force is 0 wherever N . F is positive, as
     * on the slide; then the force has a kink there, and a step across it loses its order.
     *
     * @param holding true if a rule locates the exact time of release
     */
    public void setHolding(boolean holding) {
        this.holding = holding;
    }

    /** @return whether contact lasts until a rule ends it */
    public boolean isHolding() {
        return holding;
    }

    SlidingFriction getSliding() {
        return sliding;
    }

    /** Solves rows of rods, wires and balls together with these contacts. */
    Blocks join(Rows rows, double feedback) {
        blocks = new Blocks(system, rows, feedback, this, modes::isSticking);
        impacts = new BlockImpacts(this, blocks);
        queries = new ContactQueries(this, blocks);
        return blocks;
    }

    /**
     * @param particle its index
     * @return whether it is coupled to others, which then feel an impulse on it
     */
    public boolean isCoupled(int particle) {
        return blocks.isCoupled(particle);
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
     * Corrects the velocities of a particle or its linkage after one of them was changed: no rod is stretched, no
     * touched surface is entered or left, and sticking particles stay.
     *
     * @param particle the particle, or one of the linkage
     * @param balls    whether balls in contact may not separate either
     * @param state    the state, in which velocities are changed
     */
    public void settle(int particle, boolean balls, double[] state) {
        blocks.correct(blocks.of(particle), state, 3, false, balls ? Block.ALL : Block.NONE);
    }

    /** Projects the positions and velocities of all linkages onto their rods, wires and touched surfaces. */
    public void putBack() {
        new ConstraintCorrection(blocks).project(system.getOwnState(), system.getTime());
    }

    /**
     * @param particle its index
     * @param state    the state
     * @return whether the particle is slow enough for static friction: it touches a rough surface and is slower than
     *         its threshold or round-off
     */
    public boolean isSlow(int particle, double[] state) {
        double limit = largest(particle,
                f -> f.staticCoefficient() > 0 ? Math.max(Tolerances.STANDSTILL, f.threshold()) : 0);
        Vector3 velocity = Vector3.at(state, STRIDE * particle + 3);
        return limit > 0 && velocity.dot(velocity) <= limit * limit;
    }

    /** The largest value for the friction of the surfaces that a particle touches; 0 if there is none. */
    private double largest(int particle, ToDoubleFunction<Friction> value) {
        double largest = 0;
        for (int p = 0; p < surfaces.size(); p++) {
            largest = modes.get(p, particle) == Mode.FREE ? largest
                    : Math.max(largest, value.applyAsDouble(surfaces.get(p).friction()));
        }
        return largest;
    }

    /** @return whether friction on a particle flips when it reverses, or may hold it */
    public boolean rubs(int particle) {
        return largest(particle, f -> Math.max(f.ofCoulomb(1), f.staticCoefficient())) > 0;
    }

    /** @return the largest threshold of the friction that acts on a particle (m/s), below which it may stick */
    public double threshold(int particle) {
        return largest(particle, Friction::threshold);
    }

    /**
     * Whether Coulomb friction may turn so sharply within a time that a solver fails in one step: near a stop its
     * direction turns as fast as the velocity's, however slow that is.
     *
     * @param time the length of time from now (s)
     * @return whether the forces could stop any sliding particle within that time
     */
    public boolean mayStopWithin(double time) {
        double[] force = new double[system.getStateSize()];
        system.addUpEffects(system.getOwnState(), system.getTime(), force);
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
        BitSet stopping = new BitSet();
        double[] state = system.getOwnState();
        for (int i = 0; i < modes.end(); i++) {
            double rubbing = modes.isSticking(i) ? 0 : largest(i, f -> f.ofCoulomb(1));
            if (rubbing > 0) {
                double speed = Vector3.at(state, STRIDE * i + 3).length();
                double pull = Vector3.at(forces.get(), STRIDE * i + 3).length() / particles.mass(i);
                stopping.set(i, speed <= Tolerances.STOPS * time * (1 + rubbing * sliding.sharpness(i)) * pull);
            }
        }
        return stopping;
    }

    /**
     * @param particle its index
     * @param velocity its velocity at the end of the step (m/s)
     * @return whether it has reversed within the step, is slower than the threshold of a surface, or as good as stopped
     *         where friction was to stop it
     */
    public boolean hasStopped(int particle, Vector3 velocity) {
        Vector3 before = Vector3.at(sliding.getStepBegin(), STRIDE * particle + 3);
        double slow = sliding.mayStop(particle) ? Tolerances.ALMOST_STOPPED * before.length() : 0;
        return velocity.dot(before) <= 0 || velocity.length() <= Math.max(slow, threshold(particle));
    }

    /**
     * Lets Coulomb friction act on a particle as an impulse over the step that begins: as a constant force that brings
     * it to rest after a time, as far as the friction cone allows. Near a stop the direction of exact friction turns as
     * fast as that of the velocity. Implicit solvers then do not converge and adaptive ones make no progress, above all
     * where springs stop and start a particle again and again.
     *
     * @param time from the step's start to the stop (s)
     */
    public void stopAfter(int particle, double time) {
        sliding.stopWithinStep(particle, particles.mass(particle) / time);
    }

    /**
     * @param particle its index
     * @return whether friction acts on it as an impulse in the present step
     */
    public boolean mayStop(int particle) {
        return sliding.mayStop(particle);
    }

    /** @return the state at the beginning of the step; read only */
    public double[] getStepBegin() {
        return sliding.getStepBegin();
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
        return surfaces.stream().anyMatch(surface -> surface.friction().law() != Friction.Law.NONE);
    }

    @Override
    public boolean hasForceDerivatives() {
        return true;
    }

    @Override
    public void addForceDerivatives(double[] state, double time, double[] force, ForceDerivatives derivatives) {
        blocks.getLone().addForceDerivatives(state, time, force, derivatives);
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        blocks.getLone().addForces(state, time, force);
    }

    @Override
    public double getPower(double[] state, double time, double[] force) {
        return blocks.power(state, time, force, row -> row.frictionPower(state))
                + blocks.getLone().power(state, time, force);
    }

    @Override
    public Violation getViolation(double[] state, double since) {
        Violation worst = Violation.NONE;
        for (int i = 0; i < particles.count(); i++) {
            for (int p = 0; p < surfaces.size(); p++) {
                ContactSurface surface = surfaces.get(p);
                double distance = surface.distance(state, i);
                double off = particles.isFixed(i) || particles.birthTime(i) > since
                        || modes.get(p, i) == Mode.FREE && distance > 0 ? 0 : Math.abs(distance);
                double part = off * (surface.obstacle().isFlat() ? 1 : surface.curvature(state, i));
                if (part > worst.part()) {
                    worst = new Violation(part, "'" + particles.id(i) + "' is " + Digits.few(off) + " m off '"
                            + surface.name() + "'");
                }
            }
        }
        return worst;
    }

    @Override
    public void reindex(int[] newIndex) {
        modes.reindex(newIndex);
        sliding.reindex(newIndex);
    }

    /**
     * Puts a particle on all the surfaces that it touches, with no velocity across them: all are solved together, since
     * to correct one may push the particle into another. Does nothing for a coupled particle.
     *
     * @param particle its index
     * @param state    the state, in which its position and velocity are changed
     */
    public void putOnSurfaces(int particle, double[] state) {
        Block block = blocks.of(particle);
        double near = Tolerances.PLACE * (1 + Vector3.at(state, STRIDE * particle).norm1());
        double off = Double.POSITIVE_INFINITY;
        for (int k = 0; k < MOST_ITERATIONS && off > near && !block.isJoined(); k++) {
            blocks.correct(block, state, 0, false, Block.ALL);
            off = Arrays.stream(block.rows).mapToDouble(row -> Math.abs(row.value)).max().orElse(0);
            settle(particle, false, state);
        }
    }
}
