package particles;

import java.util.List;
import java.util.function.DoubleSupplier;

/**
 * A rule that acts at exact times inside a step, "just on the plane": an impact, the end of sliding, the moment when a
 * contact lets go. The loop finds the first event in a step, repeats the step so that it ends there, lets the event
 * act, and continues with the rest of the step.
 */
public interface EventRule extends Rule {
    /**
     * An event, defined by a function of the system's state and time that changes its sign.
     *
     * @param time         an estimate of the event's time (s); the motion's beginning if it happens at once
     * @param happensAfter the side of the sign change, a difference of one ulp of the clock: false for the last time
     *                     before it, true for the first after it. A reversal or release must be complete, or it would
     *                     be found again at once
     * @param function     of the present state and time: positive before the event, 0 at it, negative after it
     * @param action       applies the event, when the system is there
     */
    record Event(double time, boolean happensAfter, DoubleSupplier function, Runnable action) {
    }

    /**
     * Finds possible events in a motion. They may be false, as the cubic is only an approximation: the loop checks them
     * with steps of the solver, the earliest first, and takes the first whose function really changes its sign.
     *
     * @param motion the step's motion, whose end is the system's present state
     * @param found  receives the possible events, in any order
     */
    void findEvents(Motion motion, List<Event> found);

    /**
     * Tells whether a step, or a part of one, may be made in two halves if the solver fails at it: where the law may
     * change within it, it changes less within a half. All rules act after each half.
     *
     * @param length the length of the part (s)
     * @param deltaT the time step (s)
     * @return whether the part may be divided
     */
    default boolean mayDivide(double length, double deltaT) {
        return false;
    }
}
