package deSolvers;

/**
 * Marks a method whose new state is the old one plus a multiple of each derivative that it evaluates: a NaN or infinity
 * in any of them shows in the new state, so that only this has to be checked.
 */
interface SumOfDerivatives {

    /** The same, except that the first derivative only leads to the state at which the second one is evaluated. */
    interface AfterTheFirst extends SumOfDerivatives {
    }
}
