package particles;

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
     * @param force holds the total force of all effects (N), in the entries where the velocities stand; receives the answer
     *              on top
     */
    void addForces(double[] state, double time, double[] force);

    /** @return whether the force depends on velocities, as friction does */
    boolean dependsOnVelocity();

    /**
     * @param state the particles' state
     * @param time  t (s)
     * @param force the total force of all effects (N), without reactions
     * @return the power that the reaction turns into heat (W), 0 or more
     */
    double getDissipatedPower(double[] state, double time, double[] force);
}
