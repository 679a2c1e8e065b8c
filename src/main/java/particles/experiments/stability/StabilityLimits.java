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
                DataTable.column("measured "), DataTable.column("measured on")), rows);
    }

    private static List<Object> row(SolverInfo info) {
        StabilityLimit real = real(info);
        StabilityLimit imaginary = imaginary(info);
        String what = info.secondOrder() ? "springs: critically damped, undamped" : info.adaptive() ? "one sub-step"
                : "a step";
        return List.of(info.name(), StabilityLimit.text(info.realLimit(), Double.NaN), real.text(),
                StabilityLimit.text(info.imaginaryLimit(), theoreticalGrowth(info.name())), imaginary.text(), what);
    }

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
