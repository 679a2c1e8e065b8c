package particles;

import java.util.List;

/**
 * A rule that acts at exact times inside a step, "just on the plane": an impact, the end of sliding, the moment when a
 * contact lets go. The loop asks what happens first in the motion of a step, takes the step again so that it ends
 * there, lets the event act, and goes on with the rest.
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
         * On which side of the sign change it happens: one rounding of the clock apart, but what has turned round or
         * lets go goes on from there, and would do it again at once if it had not quite done it.
         *
         * @return false for the last moment before it, true for the first after it
         */
        default boolean happensAfter() {
            return false;
        }

        /**
         * Lets it happen.
         *
         * @param system the system at the time of the event, to be changed
         */
        void act(ParticleSystem system);
    }

    /**
     * Looks for events in a motion. What only the cubic says need not be true: the loop tries by steps of the solver,
     * the earliest first, and takes the first one whose function does change its sign.
     *
     * @param motion a step as it was made, whose end is the system's present state; its states and the cubic between
     *               them are to be looked at
     * @param found  receives all that may have happened, in any order
     */
    void findEvents(Motion motion, List<Event> found);

    /**
     * Says where a solver may fail although neither the scene nor its step is to blame: where laws are about to change
     * within the step, and the solver has to go through what lies beyond before the event can be located. The loop then
     * goes there in shorter pieces.
     *
     * @param system the system where a step began
     * @param time   the step's length (s)
     * @return whether the way may turn sharply within that time
     */
    default boolean mayTurnWithin(ParticleSystem system, double time) {
        return false;
    }
}
