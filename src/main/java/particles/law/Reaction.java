package particles.law;

import deSolvers.ForceDerivatives;

/**
 * A force that depends on the sum of all other forces, such as the normal force of a contact, static friction, or the
 * tension of a rod. Reactions are added after all effects.
 */
public interface Reaction {

    /** @return the name in scenes and legends, such as {@code contact} */
    String getName();

    /** @return whether the reaction acts on any particle at present; if not, {@link #addForces} need not be called */
    boolean isActive();

    /**
     * Adds the reaction forces.
     *
     * @param state the particles' state, to be read only
     * @param time  t (s)
     * @param force holds the total force of all effects (N) in the entries of the velocities; the reaction is added to
     *              it
     */
    void addForces(double[] state, double time, double[] force);

    /** @return whether the force depends on velocities, as friction does */
    boolean dependsOnVelocity();

    /** @return whether {@link #addForceDerivatives} adds all derivatives; if not, solvers use finite differences */
    default boolean hasForceDerivatives() {
        return false;
    }

    /**
     * Turns the derivatives of the forces so far into those of the forces including the reaction.
     *
     * @param state  the particles' state, to be read only
     * @param time   t (s)
     * @param force  the total force before this reaction (N), in the entries of the velocities; read only
     * @param derivatives holds the derivatives that the effects have added
     */
    default void addForceDerivatives(double[] state, double time, double[] force, ForceDerivatives derivatives) {
    }

    /**
     * @return the largest acceleration that one of its forces alone gave to a particle in the last evaluation
     *         (m/s&sup2;): where such forces cancel, its round-off is left
     */
    default double getLargestAcceleration() {
        return 0;
    }

    /**
     * @param state the particles' state
     * @param time  t (s)
     * @param force the total force of all effects (N), without reactions
     * @return the exact power of the reaction (W): negative for friction, the work rate of moving anchors for rods, and
     *         0 for rods, wires and surfaces at rest, even if the state is slightly off the constraint
     */
    double getPower(double[] state, double time, double[] force);

    /** @return whether the power is only that of moving anchors, on whose account it is booked, as for rods */
    default boolean transmitsWork() {
        return false;
    }

    /**
     * @param state the particles' state
     * @param since a particle born after this time (s) may be below a surface: no rule has acted on it yet
     * @return the largest violation of a constraint that the reaction enforces
     */
    default Violation getViolation(double[] state, double since) {
        return Violation.NONE;
    }

    /**
     * Called after particles were removed from the system.
     *
     * @param newIndex for each old index, the new one, or -1 if the particle was removed
     */
    void reindex(int[] newIndex);
}
