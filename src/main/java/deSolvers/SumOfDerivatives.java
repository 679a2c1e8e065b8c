package deSolvers;

/**
 * Marker for methods whose new state is the old one plus a multiple of each derivative that they evaluate. A NaN or
 * infinity in any of them shows in the new state, so only the new state has to be checked.
 */
interface SumOfDerivatives {

    /**
     * The same, but the first derivative is not in the sum: it only leads to the state at which the second one is
     * evaluated. A NaN in it need not show in the new state, so the first derivative is checked as well.
     */
    interface AfterTheFirst extends SumOfDerivatives {
    }
}
