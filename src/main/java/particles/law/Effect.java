package particles.law;

import java.util.Set;

/**
 * A force law: the force on each particle as a function of state and time, and the energy that the law stores,
 * dissipates or supplies.
 *
 * <p>In a state array, the position of particle i is in the entries 6 i, 6 i + 1 and 6 i + 2 and its velocity in
 * 6 i + 3 to 6 i + 5. In a force array, the force on it is in the places of its velocity, 6 i + 3 to 6 i + 5.
 *
 * <p>To compute the force on one particle at a time, extend {@link ParticleForce}. A law may add interfaces:
 * {@link PerParticleEffect} and {@link DivisibleEffect} for several threads, {@link DifferentiableEffect} for the exact
 * derivatives that implicit solvers use.
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
        /**
         * Something outside the system does work, such as wind or a hand: the driven power may have either sign.
         */
        DRIVING;

        /**
         * The traits that describe a law's energy. If a law has none of them, the energy chart shows all its work
         * as one curve with the law's name.
         */
        public static final Set<Trait> OF_ENERGY = Set.of(CONSERVATIVE, DISSIPATIVE, DRIVING);

        /** @return whether it is a uniform force like gravity, whose energy has no natural zero */
        public static boolean isUniform(Effect effect) {
            return effect.getTraits().contains(TRANSLATION_INVARIANT) && !effect.getTraits().contains(INTERNAL);
        }
    }

    /**
     * Returns the law's name.
     *
     * @return the name in messages and legends, such as {@code gravity}
     */
    String getName();

    /**
     * Adds the force on every particle.
     *
     * @param state the particles' state (m, m/s), 6 doubles per particle; read only
     * @param time  t (s)
     * @param force the same layout: add the force (N) on particle i to the entries 6 i + 3 to 6 i + 5, and leave the
     *              others alone
     */
    void addForces(double[] state, double time, double[] force);

    /**
     * Returns the properties that the law declares.
     *
     * @return the properties; none by default
     */
    default Set<Trait> getTraits() {
        return Set.of();
    }

    /**
     * Tells whether the force depends on velocities, as drag and damping do.
     *
     * @return false only if it never does
     */
    default boolean dependsOnVelocity() {
        return true;
    }

    /**
     * Returns the potential energy of all particles under this law.
     *
     * @param state the particles' state
     * @param time  t (s)
     * @return the energy that the law stores in this configuration (J)
     */
    default double getPotentialEnergy(double[] state, double time) {
        return 0;
    }

    /**
     * Returns the dissipated power.
     *
     * @param state the particles' state
     * @param time  t (s)
     * @return the power that the law turns into heat (W), 0 or more
     */
    default double getDissipatedPower(double[] state, double time) {
        return 0;
    }

    /**
     * Returns the power supplied from outside, by wind for example.
     *
     * @param state the particles' state
     * @param time  t (s)
     * @return the power that something outside puts into the particles through this law (W); negative where it takes
     *         power out
     */
    default double getDrivenPower(double[] state, double time) {
        return 0;
    }

    /**
     * Called after particles were removed from the system; for laws that keep indices of particles.
     *
     * @param newIndex for each old index, the new one, or -1 if the particle was removed
     */
    default void reindex(int[] newIndex) {
    }
}
