package particles.experiments.stability;

import deSolvers.catalog.SolverInfo;
import deSolvers.catalog.SolverInfo.Family;
import deSolvers.text.Digits;
import java.util.List;
import java.util.function.DoublePredicate;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.view.DataTable;

/**
 * The stability limit in one direction of the complex plane.
 *
 * @param value  the largest h |lambda| up to which nothing grows; 0 if it always grows, infinite if it never does
 * @param growth the growth of the amplitude in a step at h |lambda| = {@value #SMALL}, as a fraction
 */
public record StabilityLimit(double value, double growth) {
    /** The h |lambda| at which growth is measured if every step grows. */
    static final double SMALL = 0.1;
    /** The least growth that counts, a few round-offs; that of bulirsch-stoer is 9e-14. */
    private static final double LEAST_GROWTH = 1e-14;
    /** A smaller growth shows that every step grows, but its digits are round-off. */
    static final double ROUND_OFF = 1e-12;
    /** A decay weaker than this may be round-off or Newton's tolerance. */
    private static final double DECAY = 1e-12;
    /**
     * The shortest step at which a decay is looked for: 1e-4 of |lambda| is the least damping that can be detected.
     */
    private static final double SHORTEST = 1e-5;
    private static final double LARGEST = 1e6;
    private static final double FACTOR = 1.02;
    private static final double ACCURACY = 1e-9;
    /** Growth of adams (PECE) at 0.1 i, from its characteristic polynomial. */
    private static final double ADAMS_GROWTH = 1.6e-7;

    /**
     * Finds the limit: increases h |lambda| until something grows, and bisects the last interval to a relative accuracy
     * of 1e-9. Where a step of 0.1 already grows, shorter ones are tried, down to 1e-5.
     *
     * @param amplification the amplification as a function of h |lambda|
     * @return the limit; beyond a million is unbounded
     */
    public static StabilityLimit measure(DoubleUnaryOperator amplification) {
        double growth = amplification.applyAsDouble(SMALL) - 1;
        if (growth > LEAST_GROWTH) {
            return new StabilityLimit(below(amplification), growth);
        }
        double stable = SMALL;
        double unstable = SMALL;
        while (isStable(amplification, unstable)) {
            stable = unstable;
            unstable *= stable < 10 ? FACTOR : 2;
            if (unstable > LARGEST) {
                return new StabilityLimit(Double.POSITIVE_INFINITY, growth);
            }
        }
        return new StabilityLimit(bisected(stable, unstable, ACCURACY, h -> isStable(amplification, h)), growth);
    }

    /** The limit if there is growth at {@link #SMALL}: damping, if there is any, is stronger in shorter steps. */
    private static double below(DoubleUnaryOperator amplification) {
        double unstable = SMALL;
        double stable = SMALL / 2;
        while (amplification.applyAsDouble(stable) > 1 - DECAY) {
            unstable = stable;
            stable /= 2;
            if (stable < SHORTEST) {
                return 0;
            }
        }
        return bisected(stable, unstable, 1e-6, h -> amplification.applyAsDouble(h) <= 1);
    }

    /** @return the largest h that is known to be stable, when the next one that is not is this close */
    private static double bisected(double stable, double unstable, double accuracy, DoublePredicate isStable) {
        double low = stable;
        double high = unstable;
        while (high - low > accuracy * low) {
            double middle = (low + high) / 2;
            if (isStable.test(middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private static boolean isStable(DoubleUnaryOperator amplification, double h) {
        return amplification.applyAsDouble(h) <= 1 + Amplification.ROUNDING;
    }

    /** @return the text in a table */
    String text() {
        return text(value, growth);
    }

    /**
     * @param value  a limit
     * @param growth the growth in a step at {@value #SMALL}, if the limit is 0
     * @return the text in a table; a dash if there is no number
     */
    static String text(double value, double growth) {
        if (Double.isNaN(value)) {
            return "-";
        }
        if (value == 0) {
            return Double.isNaN(growth) ? "always grows"
                    : growth < ROUND_OFF ? "no growth above 1e-12 per step"
                    : Digits.format("always grows: %s per step", Digits.few(growth));
        }
        return value == Double.POSITIVE_INFINITY ? "unbounded" : Digits.format("%.4f", value);
    }

    /**
     * @param solvers  the solvers
     * @param progress receives the progress
     * @return the table, a row for each solver
     */
    public static DataTable table(List<SolverChoice> solvers, ProgressListener progress) {
        return new DataTable("limits", "The largest stable deltaT |lambda|; growth is given at deltaT |lambda| = 0.1",
                Stream.of("solver", "real limit: theory", "measured", "imaginary limit: theory", "measured ",
                "damped limit: stated", "measured  ", "measured on").map(DataTable::column).toList(),
                progress.each(solvers, solver -> "limits of " + solver.label(), StabilityLimit::row));
    }

    /** Of a class of your own, nothing is stated. */
    private static List<Object> row(SolverChoice solver) {
        Amplification amplification = Amplification.of(solver);
        boolean springs = amplification.ofSprings();
        String real = real(amplification).text();
        return List.of(solver.label(), solver.info().map(info -> text(info.realLimit(), Double.NaN)).orElse("-"),
                springs ? "-" : real, solver.info().map(info -> text(info.imaginaryLimit(), theoreticalGrowth(info)))
                .orElse("-"), imaginary(amplification).text(), solver.info().filter(info -> springs).map(info ->
                text(info.dampedLimit(), Double.NaN)).orElse("-"), springs ? real : "-",
                springs ? "springs" : solver.adaptive() ? "one sub-step" : "a step");
    }

    /**
     * The real limit, or the damped limit of a symplectic method: at critical damping, both eigenvalues of a spring are
     * the same real number.
     */
    static StabilityLimit real(Amplification amplification) {
        return measure(h -> amplification.at(-h, 0));
    }

    /** @return the limit of an undamped vibration */
    public static StabilityLimit imaginary(Amplification amplification) {
        return measure(h -> amplification.at(0, h));
    }

    /** @return the growth at 0.1 i by the theory, or NaN if it is 0 or not known */
    private static double theoreticalGrowth(SolverInfo info) {
        return info.family() == Family.MULTISTEP ? ADAMS_GROWTH
                : StabilityPolynomial.of(info, SMALL).amplitude(1) - 1;
    }
}
