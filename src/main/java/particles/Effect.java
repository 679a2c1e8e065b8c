package particles;

import java.util.Optional;
import java.util.Set;

/**
 * A force law: what it does to the particles, as a function of state and time, and what it does to the energy. An effect
 * has items - particles for gravity or drag, springs for a spring network - and acts for a range of them at a time, with
 * one call per evaluation and not one per particle.
 *
 * <p>Arrays have the layout of the state: position of particle i at 6 i, 6 i + 1, 6 i + 2, its velocity in the next three
 * entries. A force stands where the velocity does, which is where its effect belongs in ds/dt.
 */
public interface Effect {

    /** What a law is held to: a test checks each claim. */
    enum Trait {
        /** Pairs of particles push each other with opposite forces: momentum is kept. */
        INTERNAL,
        /** The forces depend on no place in space, only on differences of positions and velocities. */
        TRANSLATION_INVARIANT,
        /** The forces have no direction in space of their own: angular momentum is kept if they are internal and central. */
        ROTATION_INVARIANT,
        /** Force = -grad of the potential energy; no power but what the potential stores. */
        CONSERVATIVE,
        /** Takes energy out: the dissipated power is never negative. */
        DISSIPATIVE,
        /** Something outside does work: the driven power may have either sign. */
        DRIVING
    }

    /** @return the name in scenes and legends, such as {@code gravity} */
    String getName();

    /** @return what the law claims of itself */
    Set<Trait> getTraits();

    /** @return the number of items: particles, springs, whatever the effect counts */
    int size();

    /**
     * Adds the forces of the items from ... to - 1.
     *
     * @param state the particles' state (m, m/s); 6 doubles a particle, to be read only
     * @param time  t (s)
     * @param force adds each particle's force (N) to the three entries where its velocity stands in the state; the other
     *              entries are not touched
     * @param from  first item
     * @param to    one past the last item, at most {@link #size()}
     */
    void addForces(double[] state, double time, double[] force, int from, int to);

    /**
     * Whether the items are the particles themselves and each acts on its own particle only, as gravity and drag do. Such
     * laws are evaluated for a stretch of particles in turn, while its numbers are in the processor's nearest memory.
     *
     * @return true if item i adds to the force on particle i and on no other; the same for the effect's whole life
     */
    default boolean isPerParticle() {
        return false;
    }

    /**
     * The whole law, where it is linear in the velocity and the same for all particles, as uniform gravity and viscous drag
     * in still air are. A system then evaluates the law's numbers for itself instead of calling {@link #addForces}, which
     * gives the same force.
     *
     * @return F = m g - c v by its numbers, the same ones for the effect's whole life; empty for all other laws
     */
    default Optional<LinearLaw> getLinearLaw() {
        return Optional.empty();
    }

    /**
     * Whether several threads may call {@link #addForces} at once for different ranges, as they may where it changes nothing
     * but the forces of its own items.
     *
     * @return true if they may
     */
    default boolean isConcurrent() {
        return false;
    }

    /** @return whether the force depends on velocities, as drag and damping do */
    boolean dependsOnVelocity();

    /**
     * @return whether {@link #addForceDerivatives} adds all there is; an implicit solver takes differences of the whole
     *         system where one effect does not
     */
    default boolean hasForceDerivatives() {
        return false;
    }

    /**
     * Adds the derivatives of all items' forces by positions and velocities. Laws whose force is the same everywhere and at
     * every velocity add nothing and say that this is all.
     *
     * @param state  the particles' state, to be read only
     * @param time   t (s)
     * @param derivatives receives them
     */
    default void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
    }

    /**
     * @param state the particles' state
     * @param time  t (s)
     * @return the energy that the law stores at this configuration (J); 0 for laws without a potential
     */
    default double getPotentialEnergy(double[] state, double time) {
        return 0;
    }

    /**
     * @param state the particles' state
     * @param time  t (s)
     * @return the power that the law turns into heat (W), 0 or more
     */
    default double getDissipatedPower(double[] state, double time) {
        return 0;
    }

    /**
     * @param state the particles' state
     * @param time  t (s)
     * @return the power that something outside puts into the particles through this law (W); negative where it takes
     */
    default double getDrivenPower(double[] state, double time) {
        return 0;
    }

    /**
     * Particles were taken out of the system. A law that keeps indices of particles has to follow; one that acts on all
     * there are, need not do anything.
     *
     * @param newIndex the new index of each particle by its old one, -1 for those that are gone
     */
    default void reindex(int[] newIndex) {
    }
}
