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
     * Tells whether a solver may fail in a step because the law changes within it: the solver must step across the
     * event before it can be located. The loop then retries in shorter pieces.
     *
     * @param system the system where a step began
     * @param time   the step's length (s)
     * @return whether the path may turn sharply within that time
     */
    default boolean mayTurnWithin(ParticleSystem system, double time) {
        return false;
    }

    /**
     * Tells whether a step at which the solver fails may be made in two halves. The rule acts after each, so less
     * changes within one.
     *
     * @return whether the step may be divided
     */
    default boolean mayDivide() {
        return false;
    }
}
