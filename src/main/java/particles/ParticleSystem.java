package particles;

import deSolvers.ArrayStateSource;
import deSolvers.JacobianBlocks;
import deSolvers.JacobianStateSource;
import deSolvers.SecondOrderStateSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import particles.engine.Anchors;
import particles.engine.ForceSum;
import particles.engine.ParticleJacobian;
import particles.law.AnchorMotion;
import particles.law.Effect;
import particles.law.IndexedEffect;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Vector3;

/**
 * A system of n particles in space as a source for solvers: the state is s = (x<sub>1</sub>, v<sub>1</sub>, ...,
 * x<sub>n</sub>, v<sub>n</sub>) in R<sup>6n</sup>, its derivative (v<sub>1</sub>, F<sub>1</sub>/m<sub>1</sub>, ...),
 * where F is the sum of the effects that were added, plus the reactions to that sum.
 *
 * <p>Source: COMPSCI 715 (2003), slide "Restructuring the Particle System".
 */
public final class ParticleSystem implements SecondOrderStateSource, ArrayStateSource, JacobianStateSource {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles = new Particles();
    private final List<Effect> effects = new ArrayList<>();
    private final List<Reaction> reactions = new ArrayList<>();
    private final ForceSum forces = new ForceSum(particles, effects, reactions);
    private final Anchors anchors = new Anchors();
    private final ParticleJacobian jacobian = new ParticleJacobian(this, particles, forces, effects, reactions);
    private double[] state = {};
    private double time;
    private long evaluations;

    /**
     * Adds a particle.
     *
     * @param id       its name, which must be unique (not checked here)
     * @param mass     m (kg), positive
     * @param position x (m)
     * @param velocity v (m/s); zero if it is fixed
     * @param fixed    whether it stays where it is, whatever the forces
     * @return its index
     * @throws IllegalArgumentException if mass, position or velocity is out of range
     */
    public int addParticle(String id, double mass, Vector3 position, Vector3 velocity, boolean fixed) {
        Particles.requirePossible(id, position, velocity, fixed);
        int i = particles.add(id, mass, fixed, time);
        int needed = STRIDE * particles.count();
        if (state.length < needed) {
            state = Arrays.copyOf(state, Math.max(needed, STRIDE * particles.masses().length));
        }
        double[] values = {position.x(), position.y(), position.z(), velocity.x(), velocity.y(), velocity.z()};
        System.arraycopy(values, 0, state, STRIDE * i, STRIDE);
        return i;
    }

    /**
     * Sets a particle's lifetime, which only rules and pictures use.
     * @param i         its index
     * @param birthTime when it was born (s)
     * @param deathTime when it will die of age (s); may be infinite
     */
    public void setLife(int i, double birthTime, double deathTime) {
        particles.setLife(i, birthTime, deathTime);
    }

    /**
     * Removes particles. The others keep their order and move up to fill the gaps; effects and reactions are told.
     *
     * @param gone for each particle, whether to remove it
     * @return the new index of each particle by its old one, -1 for those that are gone
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
        for (Effect effect : effects) {
            if (effect instanceof IndexedEffect indexed) {
                indexed.reindex(newIndex);
            }
        }
        reactions.forEach(reaction -> reaction.reindex(newIndex));
        return newIndex;
    }

    /**
     * Lets a fixed particle follow a given motion exactly, at every stage of a step too. It is not an unknown of the
     * equations: solvers see zeros in its place, and values they set there are ignored.
     *
     * @param particle the index of a fixed particle
     * @param motion   its motion
     * @throws IllegalArgumentException if the particle is not fixed
     */
    public void moveAnchor(int particle, AnchorMotion motion) {
        particles.requireFixed(particle);
        anchors.add(particle, motion, state, time);
    }

    /** @return the indices of the particles that are fixed to points that move */
    public int[] getMovingAnchors() {
        return anchors.particles();
    }

    /**
     * @param time          t (s)
     * @param accelerations receives the accelerations of the moving anchors (m/s&sup2;) in the entries of their
     *                      velocities; other entries are left alone
     */
    public void putAnchorAccelerations(double time, double[] accelerations) {
        anchors.accelerate(time, accelerations);
    }

    /** @param effect a force, evaluated after those added before */
    public void addEffect(Effect effect) {
        effects.add(effect);
    }

    /** @param reaction a reaction, evaluated after all effects and earlier reactions */
    public void addReaction(Reaction reaction) {
        reactions.add(reaction);
    }

    /** @return the particles' constant data: ids, masses, which are fixed */
    public Particles getParticles() {
        return particles;
    }

    /** @return the effects in the order of evaluation; read only */
    public List<Effect> getEffects() {
        return Collections.unmodifiableList(effects);
    }

    /** @return the reactions in the order of evaluation; read only */
    public List<Reaction> getReactions() {
        return Collections.unmodifiableList(reactions);
    }

    /** @return the state array itself, 6 doubles a particle, for rules and observers; do not keep a reference */
    public double[] getOwnState() {
        return state;
    }

    /** @return how often solvers evaluated the derivative */
    public long getEvaluations() {
        return evaluations;
    }

    @Override
    public int getDimension() {
        return 3;
    }

    /** Checked at each call, since springs with damping may have been added. */
    @Override
    public boolean accelerationDependsOnVelocity() {
        return forces.dependOnVelocity();
    }

    @Override
    public int getStateSize() {
        return STRIDE * particles.count();
    }

    @Override
    public void getState(double[] state) {
        System.arraycopy(this.state, 0, state, 0, getStateSize());
        anchors.hide(state);
    }

    @Override
    public void setState(double[] state) {
        System.arraycopy(state, 0, this.state, 0, getStateSize());
        anchors.put(time, this.state);
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

    @Override
    public void getStateDerivative(double[] dSdt) {
        getStateDerivative(state, dSdt);
    }

    @Override
    public void getStateDerivative(double[] state, double[] dSdt) {
        evaluations++;
        forces.derivative(anchors.shownIn(state, time, getStateSize()), time, dSdt);
        anchors.hide(dSdt);
    }

    @Override
    public double[] getStateArray() {
        trim();
        return anchors.hiddenIn(state, state.length);
    }

    private void trim() {
        if (state.length != getStateSize()) {
            state = Arrays.copyOf(state, getStateSize());
        }
    }

    @Override
    public double[] exchangeState(double[] state) {
        if (state.length != getStateSize()) {
            throw new IllegalArgumentException("a state of " + state.length + " doubles for a system of "
                    + getStateSize());
        }
        trim();
        double[] before = this.state;
        this.state = state;
        anchors.put(time, state);
        return before;
    }

    @Override
    public void getJacobianProduct(double[] direction, double[] product) {
        jacobian.multiply(state, time, anchors.freePartOf(direction, getStateSize()), product);
        anchors.hide(product);
    }

    @Override
    public Blocks getJacobianBlocks() {
        return jacobian.isExact() ? Blocks.EXACT : Blocks.APPROXIMATE;
    }

    @Override
    public void addJacobianBlocks(JacobianBlocks blocks) {
        jacobian.addBlocks(state, time, blocks);
    }

    @Override
    public double getInverseMass(int i) {
        return particles.inverseMasses()[i];
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
     * @param state a state of this system
     * @return the kinetic energy of all particles that are not fixed, the sum of m v&sup2;/2 (J)
     */
    public double getKineticEnergy(double[] state) {
        return particles.kineticEnergy(state);
    }

    /**
     * @param state a state of this system
     * @param time  t (s)
     * @return kinetic energy plus the potential energy of all effects (J)
     */
    public double getEnergy(double[] state, double time) {
        double energy = getKineticEnergy(state);
        for (Effect effect : effects) {
            energy += effect.getPotentialEnergy(state, time);
        }
        return energy;
    }
}
