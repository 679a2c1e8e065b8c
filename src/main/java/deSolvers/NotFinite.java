package deSolvers;

/** What a step says that fails because a number is not finite: which one, and why that is likely. */
final class NotFinite {
    private NotFinite() {
    }

    /** Of the clock at the end of a step: it goes nowhere from a time or by a deltaT that is not finite. */
    static String end(double time, double deltaT) {
        return !Double.isFinite(deltaT) ? "the time step has to be a finite number"
                : !Double.isFinite(time) ? "the clock of the source has to be a finite number"
                : "the clock of the source cannot go that far";
    }

    /** Of the state in which a step begins. */
    static String found(int entry, double value) {
        return "entry " + entry + " of the state is " + value
                + " before the step; whatever set the state has to be mended";
    }

    /** Of a derivative. */
    static String derivative(int entry, double value, double time) {
        return "entry " + entry + " of the derivative is " + value + " at t = " + time
                + "; the source divides by zero or overflows there";
    }

    /** Of the new state, where it is not the fault of the state and the derivative in which the step began. */
    static String made(int entry, double value) {
        return "entry " + entry + " of the state became " + value
                + " within the step, from a finite state and derivative; deltaT is probably too large, or the"
                + " derivative is not finite further on";
    }
}
