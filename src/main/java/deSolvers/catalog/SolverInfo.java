package deSolvers.catalog;

/**
 * A solver's entry in the catalogue: name, order, cost and stability limits.
 *
 * @param name           the name in scenes and on command lines, such as {@code rk4}
 * @param order          the order p: the error after a given time is proportional to deltaT<sup>p</sup>; of an embedded
 *                       pair the higher order
 * @param family         the kind of method, in a word or two
 * @param evaluations    calls of the derivative per step, in words
 * @param adaptive       whether it chooses its own sub-steps and takes tolerances
 * @param imaginaryLimit the largest stable h omega on the imaginary axis, for undamped springs; 0 if it always grows,
 *                       infinite where there is no limit, NaN where none is stated
 * @param dampedLimit    the largest stable h omega for a critically damped spring, whose eigenvalues are both -omega
 * @param sentence       a description in one sentence
 */
public record SolverInfo(String name, int order, String family, String evaluations, boolean adaptive,
                         double imaginaryLimit, double dampedLimit, String sentence) {

    /** @return the entry of a printed row: all but {@code adaptive}, with {@code none} for NaN */
    static SolverInfo of(String row, boolean adaptive) {
        String[] cells = row.split(" [|] ");
        return new SolverInfo(cells[0], Integer.parseInt(cells[1]), cells[2], cells[3], adaptive, limit(cells[4]),
                limit(cells[5]), cells[6]);
    }

    private static double limit(String cell) {
        return cell.equals("unlimited") ? Double.POSITIVE_INFINITY : cell.equals("none") ? Double.NaN
                : Double.parseDouble(cell);
    }

    /** @return whether it needs a {@link deSolvers.SecondOrderStateSource} */
    public boolean secondOrder() {
        return family.equals("symplectic");
    }

    /**
     * @return the largest stable h |lambda| on the negative real axis, NaN where it does not apply; for methods that
     *         step the state as a whole it is that of a critically damped spring
     */
    public double realLimit() {
        return secondOrder() ? Double.NaN : dampedLimit;
    }

    /**
     * @param damped whether the fastest vibration is damped
     * @return the largest stable |lambda| deltaT
     */
    public double limit(boolean damped) {
        return damped && !Double.isNaN(realLimit()) ? Math.min(realLimit(), imaginaryLimit) : imaginaryLimit;
    }

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
        return dampedLimit == Double.POSITIVE_INFINITY && imaginaryLimit == Double.POSITIVE_INFINITY;
    }
}
