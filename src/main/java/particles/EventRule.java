package particles;

import java.util.Optional;

/**
 * A rule that acts at exact times inside a step, "just on the plane": an impact, the end of sliding, the moment when a
 * contact lets go. The loop asks what happens first in the motion of a step, takes the step again so that it ends there,
 * lets the event act, and goes on with the rest.
 */
public interface EventRule extends Rule {

    /** Something that happens when a function of the state changes its sign. */
    interface Event {
        /** @return about when it happens (s); the motion's beginning for something that is due at once */
        double time();

        /**
         * @param system the system; its present state and time are looked at
         * @return positive before the event, 0 at it, negative after it
         */
        double value(ParticleSystem system);

        /**
         * Lets it happen.
         *
         * @param system the system at the time of the event, to be changed
         */
        void act(ParticleSystem system);
    }

    /**
     * Looks for the first event in a motion.
     *
     * @param motion a step as it was made, whose end is the system's present state; its states and the cubic between them
     *               are to be looked at
     * @return the first event, if there is any
     */
    Optional<Event> findEvent(Motion motion);

    /**
     * Says where a solver may fail although neither the scene nor its step is to blame: where laws are about to change
     * within the step, and the solver has to go through what lies beyond before the event can be located. The loop then goes
     * there in shorter pieces.
     *
     * @param system the system where a step began
     * @param time   the step's length (s)
     * @return whether the way may turn sharply within that time
     */
    default boolean mayTurnWithin(ParticleSystem system, double time) {
        return false;
    }
}
