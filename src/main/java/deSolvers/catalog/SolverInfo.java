package deSolvers.catalog;

/**
 * A solver's entry in the catalogue: name, order, cost and stability limits.
 *
 * @param name        the name in scenes and on command lines, such as {@code rk4}
 * @param order       the order p: the error after a given time is proportional to deltaT<sup>p</sup>; of an embedded
 *                    pair the higher order
 * @param family      the kind of method
 * @param evaluations calls of the derivative per step, in words
 * @param adaptive    whether it chooses its own sub-steps and takes tolerances
 * @param limits      its stability limits
 * @param look        its look in charts
 * @param sentence    a description in one sentence
 */
public record SolverInfo(String name, int order, Family family, String evaluations, boolean adaptive, Limits limits,
                         ChartLook look, String sentence) {
    /** The kinds of methods; in charts, those of one group have one hue. */
    public enum Family {
        /** Explicit Runge-Kutta methods of the slides. */
        SLIDES(Group.EXPLICIT),
        /** Methods that use earlier steps. */
        MULTISTEP(Group.EXPLICIT),
        /** Runge-Kutta methods that choose their sub-steps. */
        ADAPTIVE(Group.ADAPTIVE),
        /** Extrapolation of steps of ever shorter sub-steps. */
        EXTRAPOLATION(Group.ADAPTIVE),
        /** Methods for positions and velocities. */
        SYMPLECTIC(Group.SYMPLECTIC),
        /** Methods that solve equations in each step. */
        IMPLICIT(Group.IMPLICIT);

        private final Group group;

        Family(Group group) {
            this.group = group;
        }

        /** @return its group in charts with many solvers */
        public Group group() {
            return group;
        }
    }

    /** Groups of families. */
    public enum Group {
        /** Explicit methods with a fixed step. */
        EXPLICIT("explicit, fixed step"),
        /** Explicit methods that choose their sub-steps. */
        ADAPTIVE("explicit, adaptive"),
        /** Methods for positions and velocities. */
        SYMPLECTIC("symplectic"),
        /** Methods that solve equations in each step. */
        IMPLICIT("implicit");

        /** The group in words. */
        public final String words;

        Group(String words) {
            this.words = words;
        }
    }

    /**
     * Stability limits.
     *
     * @param imaginary the largest stable h omega on the imaginary axis, for undamped springs; 0 if it always grows,
     *                  infinite where there is no limit, NaN where none is stated
     * @param damped    the largest stable h omega for a critically damped spring, whose eigenvalues are both -omega
     */
    public record Limits(double imaginary, double damped) {
        /** No step is too long. */
        static final Limits NONE = new Limits(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        /** Of a method whose sub-steps differ, none is stated. */
        static final Limits UNSTATED = new Limits(Double.NaN, Double.NaN);
    }

    /**
     * The look in charts: the hue shows the group; lightness, dashes and points show the solver, so that the members of
     * a group differ in grey print too.
     *
     * @param rgb     its colour on white, 0xRRGGBB
     * @param variant the number of its dashes and of the shape of its points
     */
    public record ChartLook(int rgb, int variant) {
    }

    /** @return the largest stable h omega of an undamped spring */
    public double imaginaryLimit() {
        return limits.imaginary();
    }

    /** @return the largest stable h omega of a critically damped spring */
    public double dampedLimit() {
        return limits.damped();
    }

    /** @return whether it needs a {@link deSolvers.SecondOrderStateSource} */
    public boolean secondOrder() {
        return family == Family.SYMPLECTIC;
    }

    /**
     * @return the largest stable h |lambda| on the negative real axis, NaN where it does not apply; for methods that
     *         step the state as a whole it is that of a critically damped spring
     */
    public double realLimit() {
        return secondOrder() ? Double.NaN : limits.damped();
    }

    /**
     * @param damped whether the fastest vibration is damped
     * @return the largest stable |lambda| deltaT
     */
    public double limit(boolean damped) {
        return damped && !Double.isNaN(realLimit()) ? Math.min(realLimit(), imaginaryLimit()) : imaginaryLimit();
    }

    /** @return whether each step solves equations, so that evaluations are not all its work */
    public boolean implicit() {
        return family == Family.IMPLICIT;
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
        return limits.damped() == Double.POSITIVE_INFINITY && limits.imaginary() == Double.POSITIVE_INFINITY;
    }
}
