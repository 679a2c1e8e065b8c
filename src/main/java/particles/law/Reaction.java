package particles.law;

/**
 * A force that answers the total of all others: resting contact and its friction push back just as hard as they are
 * pushed. Acts after all effects.
 */
public interface Reaction {

    /** @return the name in scenes and legends, such as {@code contact} */
    String getName();

    /** @return whether any particle is held at present; if none is, {@link #addForces} need not be called */
    boolean isActive();

    /**
     * Adds the answering forces.
     *
     * @param state the particles' state, to be read only
     * @param time  t (s)
     * @param force holds the total force of all effects (N), in the entries where the velocities stand; receives the
     *              answer on top
     */
    void addForces(double[] state, double time, double[] force);

    /** @return whether the force depends on velocities, as friction does */
    boolean dependsOnVelocity();

    /** @return whether {@link #addForceDerivatives} adds all there is */
    default boolean hasForceDerivatives() {
        return false;
    }

    /**
     * Makes the derivatives of the forces so far those of the forces with the answer.
     *
     * @param state  the particles' state, to be read only
     * @param time   t (s)
     * @param force  the total force before this reaction (N), in the entries where the velocities stand; to be read
     *               only
     * @param derivatives holds what the effects have added
     */
    default void addForceDerivatives(double[] state, double time, double[] force, ForceDerivatives derivatives) {
    }

    /**
     * @param state the particles' state
     * @param time  t (s)
     * @param force the total force of all effects (N), without reactions
     * @return the power that physics gives (W): negative where friction turns it into heat, that of moving anchors
     *         through rods, 0 for rods, wires and surfaces that stand still, whatever a state that is not quite on them
     *         would give
     */
    double getPower(double[] state, double time, double[] force);

    /**
     * Particles were taken out of the system.
     *
     * @param newIndex the new index of each particle by its old one, -1 for those that are gone
     */
    void reindex(int[] newIndex);
}
