package particles.law;

import java.util.Set;

/**
 * A force law: the force on each particle as a function of state and time, and where the energy goes.
 *
 * <p>Arrays have the layout of the state: the position of particle i in the entries 6 i, 6 i + 1 and 6 i + 2, its
 * velocity in the next three, its force where the velocity stands.
 *
 * <p>To compute the force on one particle at a time, extend {@link ParticleForce}. A law may add interfaces:
 * {@link PerParticleEffect} and {@link DivisibleEffect} for several threads, {@link DifferentiableEffect} for the exact
 * derivatives that implicit solvers use, {@link IndexedEffect} if it keeps indices of particles.
 */
public interface Effect {

    /** A property that a force law declares; tests check it. */
    enum Trait {
        /** Pairs of particles push each other with opposite forces: momentum is conserved. */
        INTERNAL,
        /** The forces depend only on differences of positions and on velocities. */
        TRANSLATION_INVARIANT,
        /** The forces prefer no direction: angular momentum is conserved if they are internal and central. */
        ROTATION_INVARIANT,
        /** Force = -grad of the potential energy. */
        CONSERVATIVE,
        /** Takes energy out: the dissipated power is never negative. */
        DISSIPATIVE,
        /** Something outside does work: the driven power may have either sign. */
        DRIVING;

        /** A law that claims none of these says nothing of its energy, and whatever work it does is its own. */
        public static final Set<Trait> OF_ENERGY = Set.of(CONSERVATIVE, DISSIPATIVE, DRIVING);
    }

    /** @return the name in messages and legends, such as {@code gravity} */
    String getName();

    /**
     * Adds the force on every particle.
     *
     * @param state the particles' state (m, m/s), 6 doubles a particle; read only
     * @param time  t (s)
     * @param force the same layout: add the force (N) on particle i to the entries 6 i + 3 to 6 i + 5, and leave the
     *              others alone
     */
    void addForces(double[] state, double time, double[] force);

    /** @return the properties that the law declares */
    default Set<Trait> getTraits() {
        return Set.of();
    }

    /** @return whether the force depends on velocities, as drag and damping do */
    default boolean dependsOnVelocity() {
        return true;
    }

    /**
     * @param state the particles' state
     * @param time  t (s)
     * @return the energy that the law stores in this configuration (J)
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
     *         power out
     */
    default double getDrivenPower(double[] state, double time) {
        return 0;
    }
}
