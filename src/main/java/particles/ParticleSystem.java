package particles;

import deSolvers.ArrayStateSource;
import deSolvers.ForceDerivatives;
import deSolvers.JacobianStateSource;
import deSolvers.SubStepSource;
import deSolvers.TimeScaleSource;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import particles.engine.Anchors;
import particles.engine.ForceSum;
import particles.law.AnchorMotion;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Vector3;

/**
 * A system of n particles in space as a source for solvers: the state is s = (x<sub>1</sub>, v<sub>1</sub>, ...,
 * x<sub>n</sub>, v<sub>n</sub>) in R<sup>6n</sup>, its derivative (v<sub>1</sub>, F<sub>1</sub>/m<sub>1</sub>, ...).
 * The force F is the sum of all {@linkplain Effect effects}, such as gravity and springs, plus the {@linkplain Reaction
 * constraint and contact forces}, which depend on that sum.
 *
 * <p>Source: COMPSCI 715 (2003), slide "Restructuring the Particle System".
 */
public final class ParticleSystem implements JacobianStateSource, ArrayStateSource, SubStepSource,
        TimeScaleSource {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles = new Particles();
    private final ForceSum forces = new ForceSum(particles);
    private final Anchors anchors = new Anchors();      // hides their places from solvers, shows them to forces
    private double[] state = {};
    private double time;
    private long evaluations;
    private Optional<Motion> recorded = Optional.empty();

    /**
     * Adds a particle.
     *
     * @param id       its name, which must be unique (not checked here)
     * @param mass     m (kg), positive
     * @param position x (m)
     * @param velocity v (m/s); zero if it is fixed
     * @param fixed    whether no force moves it
     * @return its index
     * @throws IllegalArgumentException if mass, position or velocity is out of range
     */
    public int addParticle(String id, double mass, Vector3 position, Vector3 velocity, boolean fixed) {
        Particles.requirePossible(id, position, velocity, fixed);
        int i = particles.add(id, mass, fixed, time);
        int needed = STRIDE * particles.count();
        if (state.length < needed) {
            state = Arrays.copyOf(state, Math.max(needed, STRIDE * particles.getMasses().length));
        }
        position.put(state, STRIDE * i);
        velocity.put(state, STRIDE * i + 3);
        return i;
    }

    /**
     * Sets a particle's lifetime, which only rules and pictures use.
     *
     * @param i         its index
     * @param birthTime the time of its birth (s)
     * @param deathTime the time at which its lifetime ends (s); may be infinite
     */
    public void setLife(int i, double birthTime, double deathTime) {
        particles.setLife(i, birthTime, deathTime);
    }

    /**
     * Removes particles. The others keep their order and move up to fill the gaps; effects and reactions update their
     * indices.
     *
     * @param gone for each particle, whether to remove it
     * @return for each old index, the new one, or -1 if the particle was removed
     */
    public int[] removeParticles(boolean[] gone) {
        int[] newIndex = new int[particles.count()];
        int stay = 0;
        for (int i = 0; i < newIndex.length; i++) {
            if (gone[i]) {
                newIndex[i] = -1;
                continue;
            }
            particles.move(i, stay);
            System.arraycopy(state, STRIDE * i, state, STRIDE * stay, STRIDE);
            newIndex[i] = stay++;
        }
        particles.shrinkTo(stay);
        anchors.reindex(newIndex);
        getEffects().forEach(effect -> effect.reindex(newIndex));
        getReactions().forEach(reaction -> reaction.reindex(newIndex));
        return newIndex;
    }

    /**
     * Turns a fixed particle into a moving anchor: its motion is prescribed, and forces do not affect it. Forces are
     * always computed with the anchor's exact position at that time, inside steps too. The anchor is not an unknown of
     * the equations: solvers see zeros in its place, and values they set there are ignored.
     *
     * @param particle the index of a fixed particle
     * @param motion   its motion
     * @throws IllegalArgumentException if the particle is not fixed
     */
    public void moveAnchor(int particle, AnchorMotion motion) {
        particles.requireFixed(particle);
        anchors.add(particle, motion, state, time);
    }

    /** @return the indices of the moving anchors, the particles whose motion is prescribed */
    public int[] getMovingAnchors() {
        return anchors.particles();
    }

    /**
     * Writes the accelerations of the moving anchors into an array.
     *
     * @param time          t (s)
     * @param accelerations receives the accelerations of the moving anchors (m/s&sup2;) in the entries of their
     *                      velocities, and 0 in all others
     */
    public void putAnchorAccelerations(double time, double[] accelerations) {
        Arrays.fill(accelerations, 0);          // an index may have been that of a particle which is gone
        anchors.accelerate(time, accelerations);
    }

    /**
     * Adds a force law.
     *
     * @param effect the law
     */
    public void addEffect(Effect effect) {
        forces.add(effect);
    }

    /**
     * Adds a reaction: constraint or contact forces.
     *
     * @param reaction the reaction, evaluated after all effects and earlier reactions; if a particle on a rod or wire,
     *                 or in contact with a ball, also touches a surface, {@code RigidConstraints} solves for all these
     *                 forces together, instead of {@code RestingContacts}
     */
    public void addReaction(Reaction reaction) {
        forces.add(reaction);
    }

    /**
     * Returns the particles' constant data.
     *
     * @return ids, masses and lifetimes, and which particles are fixed
     */
    public Particles getParticles() {
        return particles;
    }

    /**
     * Returns the force laws.
     *
     * @return the effects in the order in which they were added; read only
     */
    public List<Effect> getEffects() {
        return forces.getEffects();
    }

    /**
     * Returns the reactions.
     *
     * @return the reactions in the order of evaluation; read only
     */
    public List<Reaction> getReactions() {
        return forces.getReactions();
    }

    /**
     * Returns the state array itself, for rules and observers.
     *
     * @return s with the moving anchors at their places, {@link #getStateSize()} long; keep no reference
     */
    public double[] getOwnState() {
        if (state.length != getStateSize()) {           // addParticle leaves room for more
            state = Arrays.copyOf(state, getStateSize());
        }
        return state;
    }

    /** @return the number of evaluations of the derivative by solvers */
    public long getEvaluations() {
        return evaluations;
    }

    @Override
    public int getDimension() {
        return 3;
    }

    /** Whether any force depends on velocities; asked anew at each call, since springs may have been added. */
    @Override
    public boolean accelerationDependsOnVelocity() {
        return forces.dependOnVelocity();
    }

    @Override
    public double getLargestTerm() {
        return forces.getLargestAcceleration();
    }

    @Override
    public int getStateSize() {
        return STRIDE * particles.count();
    }

    @Override
    public void getState(double[] state) {
        System.arraycopy(this.state, 0, state, 0, state.length);
        anchors.hide(state);
    }

    @Override
    public void setState(double[] state) {
        System.arraycopy(state, 0, getOwnState(), 0, state.length);
        anchors.put(time, this.state);
    }

    @Override
    public double[] exchangeState(double[] state) {
        double[] former = getOwnState();
        this.state = state;
        anchors.put(time, state);
        return former;
    }

    @Override
    public double getTime() {
        return time;
    }

    /** Sets the clock to exactly this time; incTime with a difference might be off by round-off. */
    void setTime(double time) {
        this.time = time;
        anchors.put(time, state);
    }

    @Override
    public void incTime(double deltaT) {
        setTime(time + deltaT);
    }

    /** Sets the motion that is being recorded, if any. */
    void record(Optional<Motion> motion) {
        recorded = motion;
    }

    @Override
    public void subStepTaken(double[] state, double time) {
        recorded.ifPresent(motion -> motion.addStop(anchors.shownIn(state, time), time));
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        getStateDerivative(getOwnState(), dSdt);
    }

    @Override
    public void getStateDerivative(double[] state, double[] dSdt) {
        getIncrement(state, 1, dSdt);
    }

    @Override
    public void getIncrement(double[] state, double deltaT, double[] deltaS) {
        evaluations++;
        forces.derivative(anchors.shownIn(state, time), time, deltaT, deltaS);
        anchors.hide(deltaS);
    }

    /** The state array itself, for solvers; with moving anchors a copy, in which their places are 0. */
    @Override
    public double[] getStateArray() {
        return anchors.hiddenIn(getOwnState());
    }

    /** {@inheritDoc} That of all effects and moving anchors. */
    @Override
    public double getShortestTime(double[] state, double time) {
        double anchored = anchors.getShortestTime(time);
        return !forces.hasBriefForces() ? anchored
                : Math.min(anchored, forces.getShortestTime(anchors.shownIn(state, time), time));
    }

    /** {@inheritDoc} Such a change is a passage through the reach of a force. */
    @Override
    public double findPassage(double[] from, double beginning, double[] to, double end) {
        return !forces.hasBriefForces() ? Double.POSITIVE_INFINITY
                : forces.findPassage(anchors.shownInBeginning(from, beginning), anchors.shownIn(to, end),
                end - beginning);
    }

    @Override
    public boolean hasExactJacobian() {
        return forces.hasDerivatives();
    }

    @Override
    public void addJacobianBlocks(ForceDerivatives blocks) {
        forces.addDerivatives(state, time, blocks);
    }

    @Override
    public double getInverseMass(int i) {
        return particles.getInverseMasses()[i];
    }

    /** @return the sum of this system's forces, for example to evaluate it on several threads */
    public ForceSum getForceSum() {
        return forces;
    }

    /**
     * Computes the sum of all effects without the reactions, for ledgers and checks; not counted as an evaluation.
     *
     * @param state a state of this system
     * @param time  t (s)
     * @param force receives the forces (N) in the entries of the velocities, 0 in the others
     */
    public void addUpEffects(double[] state, double time, double[] force) {
        forces.effects(state, time, force);
    }

    /**
     * Computes the kinetic energy.
     *
     * @param state a state of this system
     * @return the kinetic energy of all particles that are not fixed, the sum of m v&sup2;/2 (J)
     */
    public double getKineticEnergy(double[] state) {
        return particles.kineticEnergy(state);
    }

    /**
     * Computes the energy of motion and of the forces between particles.
     *
     * @param state a state of this system
     * @param time  t (s)
     * @return kinetic energy plus the potential energy of all internal forces (J)
     */
    public double getInternalEnergy(double[] state, double time) {
        double energy = getKineticEnergy(state);
        for (Effect effect : getEffects()) {
            if (effect.getTraits().contains(Effect.Trait.INTERNAL)) {
                energy += effect.getPotentialEnergy(state, time);
            }
        }
        return energy;
    }

    /**
     * Computes the total energy.
     *
     * @param state a state of this system
     * @param time  t (s)
     * @return kinetic energy plus the potential energy of all effects (J)
     */
    public double getEnergy(double[] state, double time) {
        double energy = getKineticEnergy(state);
        for (Effect effect : getEffects()) {
            energy += effect.getPotentialEnergy(state, time);
        }
        return energy;
    }
}
