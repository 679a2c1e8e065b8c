package deSolvers;

/** Messages for steps that fail on NaN or infinity: the number and its likely cause. */
final class NotFinite {
    private NotFinite() {
    }

    /** For a time or a deltaT that is not finite. */
    static String end(double time, double deltaT) {
        return !Double.isFinite(deltaT) ? "the time step has to be a finite number"
                : !Double.isFinite(time) ? "the clock of the source has to be a finite number"
                : "the clock of the source cannot go that far";
    }

    /** For the state in which a step begins. */
    static String found(int entry, double value) {
        return "entry " + entry + " of the state is " + value
                + " before the step; whatever set the state has to be mended";
    }

    /** For a derivative. */
    static String derivative(int entry, double value, double time) {
        return "entry " + entry + " of the derivative is " + value + " at t = " + time
                + "; the source divides by zero or overflows there";
    }

    /** For the new state, if the state and the derivative at the beginning of the step are finite. */
    static String made(int entry, double value) {
        return "entry " + entry + " of the state became " + value
                + " within the step, from a finite state and derivative; deltaT is probably too large, or the"
                + " derivative is not finite further on";
    }
}
