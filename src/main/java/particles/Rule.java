package particles;

import particles.law.Violation;

/**
 * A law that acts between steps, never inside the derivative: a bounce, a birth, a tear, or the change from sliding to
 * sticking. A rule may change anything at the end of a step.
 */
public interface Rule {

    /** @return the name in scenes and messages, such as {@code impacts} */
    String getName();

    /**
     * @return whether the rule only corrects errors of steps; the energy that it adds or removes then counts as
     *         numerical error
     */
    default boolean isCorrection() {
        return false;
    }

    /**
     * @param system the system
     * @return how far its present state is off what the rule keeps
     */
    default Violation getViolation(ParticleSystem system) {
        return Violation.NONE;
    }

    /**
     * Called before the first step; finds, for example, which particles rest on a plane from the start.
     *
     * @param system the system as the scene describes it
     */
    default void start(ParticleSystem system) {
    }

    /**
     * Called before each step.
     *
     * @param system the system; read only
     * @param deltaT the length of the step (s); an event may end it earlier
     */
    default void beforeStep(ParticleSystem system, double deltaT) {
    }

    /**
     * Returns the time at which the rule acts next, if it knows that beforehand. The loop ends a step there, and begins
     * a new one for the rest.
     *
     * @return the time (s); infinite by default
     */
    default double getNextTime() {
        return Double.POSITIVE_INFINITY;
    }

    /** @return the number of births that are due and wait for room */
    default long getWaiting() {
        return 0;
    }

    /**
     * Called at the end of each step; may change the system.
     *
     * @param system the system
     * @param deltaT the step that was made (s)
     * @return whether anything was changed; if so, the solver is reset
     */
    boolean afterStep(ParticleSystem system, double deltaT);
}
