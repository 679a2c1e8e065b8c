package particles.experiments.stability;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.ArrayList;
import java.util.List;
import particles.experiments.runs.ProgressListener;
import particles.view.DataTable;

/** The limits on both axes, measured on every solver's real code, beside what theory says. */
public final class StabilityLimits {
    /** Of the method in PECE form at 0.1 i, from its characteristic polynomial. */
    private static final double ADAMS_GROWTH = 1.6e-7;

    private static final String NOTHING = "-";

    private StabilityLimits() {
    }

    /**
     * @param progress hears how far it is
     * @return the table, a row for each solver of the catalogue
     */
    public static DataTable measure(ProgressListener progress) {
        List<List<Object>> rows = new ArrayList<>();
        List<SolverInfo> all = SolverCatalog.all();
        for (SolverInfo info : all) {
            progress.reached((double) rows.size() / all.size(), "limits of " + info.name());
            rows.add(row(info));
        }
        return new DataTable("limits", "The largest stable h |lambda|; growth is that at 0.1",
                List.of(DataTable.column("solver"),
                DataTable.column("real axis: theory"), DataTable.column("measured"),
                DataTable.column("imaginary axis: theory"),
                DataTable.column("measured "), DataTable.column("critically damped spring: stated"),
                DataTable.column("measured  "), DataTable.column("measured on")), rows);
    }

    /** @return which solvers have no limit, and which are never stable, in a sentence */
    public static String finding() {
        List<String> free = SolverCatalog.all().stream().filter(info -> info.realLimit() == Double.POSITIVE_INFINITY
                && info.imaginaryLimit() == Double.POSITIVE_INFINITY).map(SolverInfo::name).toList();
        List<String> never = SolverCatalog.all().stream().filter(info -> info.imaginaryLimit() == 0)
                .map(SolverInfo::name).toList();
        return "A step has no limit with " + together(free) + "; with " + together(never)
                + " every undamped spring grows";
    }

    private static String together(List<String> names) {
        int last = names.size() - 1;
        return String.join(", ", names.subList(0, last)) + " and " + names.get(last);
    }

    private static List<Object> row(SolverInfo info) {
        boolean springs = info.secondOrder();
        String real = real(info).text();
        String what = springs ? "springs" : info.adaptive() ? "one sub-step"
                : "a step";
        return List.of(info.name(), StabilityLimit.text(info.realLimit(), Double.NaN), springs ? NOTHING : real,
                StabilityLimit.text(info.imaginaryLimit(), theoreticalGrowth(info.name())), imaginary(info).text(),
                springs ? StabilityLimit.text(info.dampedLimit(), Double.NaN) : NOTHING,
                springs ? real : NOTHING, what);
    }

    /** Of a symplectic method on a critically damped spring, whose two eigenvalues are real and equal. */
    static StabilityLimit real(SolverInfo info) {
        Amplification amplification = Amplification.of(info);
        return StabilityLimit.measure(h -> amplification.at(-h, 0));
    }

    static StabilityLimit imaginary(SolverInfo info) {
        Amplification amplification = Amplification.of(info);
        return StabilityLimit.measure(h -> amplification.at(0, h));
    }

    /** @return what theory says a step at 0.1 i adds, where that is known and not 0 */
    private static double theoreticalGrowth(String solver) {
        return solver.equals("adams") ? ADAMS_GROWTH
                : StabilityPolynomial.of(solver, StabilityLimit.SMALL).map(r -> r.amplitude(1) - 1).orElse(Double.NaN);
    }
}
