package particles;

/**
 * A law that acts between steps, never inside the derivative: a bounce, a birth, a tear, or the change of a reaction's
 * mode. Rules see a step's beginning and its end and may change anything at the end.
 */
public interface Rule {

    /** @return the name in scenes and messages, such as {@code impacts} */
    String getName();

    /**
     * @return whether all it changes mends errors of the steps, so that energy that it gives or takes is an error as
     *         well
     */
    default boolean isCorrection() {
        return false;
    }

    /**
     * Looks at the system before the first step and puts in order what the scene left open, such as which particles
     * rest on a plane from the start.
     *
     * @param system the system as the scene describes it
     */
    default void start(ParticleSystem system) {
    }

    /**
     * Looks at the system before a step.
     *
     * @param system the system, to be read only
     */
    default void beforeStep(ParticleSystem system) {
    }

    /**
     * Acts at the end of a step.
     *
     * @param system the system, to be changed as the rule says
     * @param deltaT the step that was made (s)
     * @return whether anything was changed: state, modes, particles; the solver is then told to forget the past
     */
    boolean afterStep(ParticleSystem system, double deltaT);
}
