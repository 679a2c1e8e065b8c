package particles.experiments.stability;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.List;
import java.util.stream.Stream;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SolverChoice;
import particles.view.DataTable;

/** The stability limits of all solvers: those measured on their code, and those of the theory. */
public final class StabilityLimits {
    /** Growth of adams (PECE) at 0.1 i, from its characteristic polynomial. */
    private static final double ADAMS_GROWTH = 1.6e-7;

    private static final String NOTHING = "-";

    private StabilityLimits() {
    }

    /**
     * @param progress receives the progress
     * @return the table, a row for each solver of the catalogue
     */
    public static DataTable measure(ProgressListener progress) {
        return new DataTable("limits", "The largest stable deltaT |lambda|; growth is given at deltaT |lambda| = 0.1",
                Stream.of("solver", "real limit: theory", "measured", "imaginary limit: theory", "measured ",
                "damped limit: stated", "measured  ", "measured on").map(DataTable::column).toList(),
                progress.each(SolverCatalog.all(), info -> "limits of " + info.name(), StabilityLimits::row));
    }

    /** @return a sentence: the solvers without a limit, and those that are never stable */
    public static String finding() {
        List<String> free = SolverCatalog.all().stream().filter(SolverInfo::unlimited).map(SolverInfo::name).toList();
        List<String> never = SolverCatalog.all().stream().filter(info -> info.imaginaryLimit() == 0)
                .map(SolverInfo::name).toList();
        return "A step has no limit with " + SolverChoice.together(free) + "; with " + SolverChoice.together(never)
                + " an undamped spring grows in every step";
    }

    private static List<Object> row(SolverInfo info) {
        boolean springs = info.secondOrder();
        String real = real(info).text();
        String what = springs ? "springs" : info.adaptive() ? "one sub-step" : "a step";
        return List.of(info.name(), StabilityLimit.text(info.realLimit(), Double.NaN), springs ? NOTHING : real,
                StabilityLimit.text(info.imaginaryLimit(), theoreticalGrowth(info)), imaginary(info).text(),
                springs ? StabilityLimit.text(info.dampedLimit(), Double.NaN) : NOTHING,
                springs ? real : NOTHING, what);
    }

    /**
     * The real limit, or the damped limit of a symplectic method: at critical damping, both eigenvalues of a spring are
     * the same real number.
     */
    static StabilityLimit real(SolverInfo info) {
        Amplification amplification = Amplification.of(info);
        return StabilityLimit.measure(h -> amplification.at(-h, 0));
    }

    static StabilityLimit imaginary(SolverInfo info) {
        Amplification amplification = Amplification.of(info);
        return StabilityLimit.measure(h -> amplification.at(0, h));
    }

    /** @return the growth at 0.1 i by the theory, or NaN if it is 0 or not known */
    private static double theoreticalGrowth(SolverInfo info) {
        return info.family().equals("multistep") ? ADAMS_GROWTH
                : StabilityPolynomial.of(info, StabilityLimit.SMALL).amplitude(1) - 1;
    }
}
