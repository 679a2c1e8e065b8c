package deSolvers.catalog;

/**
 * A solver's entry in the catalogue: name, class, order, cost and stability limits.
 *
 * @param name           the name in scenes and on command lines, such as {@code rk4}
 * @param className      the fully-qualified name of its class
 * @param order          the order p: the error after a given time is proportional to deltaT<sup>p</sup>; of an embedded
 *                       pair the higher order
 * @param family         the kind of method, in a word or two
 * @param evaluations    calls of the derivative per step, in words
 * @param adaptive       whether it chooses its own sub-steps and takes tolerances
 * @param secondOrder    whether it needs a {@link deSolvers.SecondOrderStateSource}
 * @param realLimit      the largest stable h |lambda| on the negative real axis; infinite where there is none, NaN
 *                       where it does not apply
 * @param imaginaryLimit the largest stable h omega on the imaginary axis, for undamped springs; 0 if it always grows
 * @param dampedLimit    the largest stable h omega for a critically damped spring, whose eigenvalues are both -omega;
 *                       for methods that step the state as a whole it is realLimit
 * @param sentence       a description in one sentence
 */
public record SolverInfo(String name, String className, int order, String family, String evaluations, boolean adaptive,
                         boolean secondOrder, double realLimit, double imaginaryLimit, double dampedLimit,
                         String sentence) {

    /** @return whether each step solves equations, so that evaluations are not all its work */
    public boolean implicit() {
        return family.equals("implicit");
    }

    /**
     * @return whether it steps by deltaT and damps what vibrates too fast for that: Euler's implicit method and its
     *         linearised step, whose amplification is 1 / (1 - h lambda)
     */
    public boolean damping() {
        return implicit() && !adaptive && order == 1;
    }

    /** @return whether a step has no stability limit, for damped and for undamped springs */
    public boolean unlimited() {
        return realLimit == Double.POSITIVE_INFINITY && imaginaryLimit == Double.POSITIVE_INFINITY;
    }
}
