package particles.experiments.energy;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.energy.EnergyDrift.Kind;
import particles.experiments.runs.SolverChoice;

/** One sentence about a comparison: each solver's energy error with its size, the worst first. */
final class DriftHeadline {
    /** The largest number of solvers named; the others, which are better, are summed up in the last place. */
    private static final int NAMED = 4;
    /** From ten times the energy on, a percentage is hard to read. */
    private static final double MANY_TIMES = 10;

    private DriftHeadline() {
    }

    static String of(Comparison comparison) {
        return start(comparison) + parts(comparison) + end(comparison);
    }

    /** Of a chart that ends at a part of the energy scale: the solvers that leave it, then the others. */
    static String within(double limit, Comparison comparison) {
        List<String> far = comparison.drifts().stream().filter(drift -> drift.largest() > limit)
                .map(DriftHeadline::label).toList();
        Comparison near = comparison.only(drift -> drift.largest() <= limit);
        return start(comparison) + (far.isEmpty() ? "" : said(far, "exceeds " + part(limit)))
                + (far.isEmpty() || near.drifts().isEmpty() ? "" : "; ") + parts(near) + end(comparison);
    }

    private static String start(Comparison comparison) {
        boolean exchanges = comparison.drifts().stream().anyMatch(drift -> drift.kind() == Kind.EXCHANGING);
        return comparison.scene() + (exchanges ? ", numerical energy error: " : ": ");
    }

    private static String end(Comparison comparison) {
        return comparison.equalWork() ? " (equal evaluations)" : "";
    }

    private static String parts(Comparison comparison) {
        List<Drift> drifts = comparison.drifts().stream().sorted(WORST_FIRST).toList();
        Map<String, List<String>> verdicts = new LinkedHashMap<>();     // equal ones share a place
        for (Drift drift : drifts) {
            verdicts.computeIfAbsent(verdict(drift), verdict -> new ArrayList<>()).add(label(drift));
        }
        int places = verdicts.size() <= NAMED + 1 ? verdicts.size() : NAMED;
        String parts = verdicts.entrySet().stream().limit(places).map(place -> said(place.getValue(), place.getKey()))
                .collect(Collectors.joining("; "));
        long named = verdicts.values().stream().limit(places).mapToLong(List::size).sum();
        String others = named == drifts.size() ? "" : "; the other " + (drifts.size() - named)
                + " are off by at most " + part(drifts.stream().filter(drift -> verdicts.keySet().stream().skip(places)
                .anyMatch(verdict(drift)::equals)).mapToDouble(DriftHeadline::size).max().orElse(0));
        return parts + others;
    }

    /** One solver gains, stays, blows up; several gain, stay, blow up. */
    private static String said(List<String> solvers, String verdict) {
        return SolverChoice.together(solvers) + " " + (solvers.size() == 1 ? verdict
                : verdict.replaceFirst("^is ", "are ").replaceFirst("^(\\w+)s ", "$1 "));
    }

    /** Failures come first, by the time that they reached, then the others by the size of their error. */
    private static final Comparator<Drift> WORST_FIRST = Comparator
            .comparing((Drift drift) -> drift.kind() != Kind.FAILED)
            .thenComparingDouble(drift -> drift.kind() == Kind.FAILED ? drift.outcome().endTime() : -size(drift));

    /** A drift is measured at its end, an oscillation by its largest amplitude. */
    private static double size(Drift drift) {
        return drift.kind() == Kind.SECULAR ? Math.abs(drift.end()) : drift.largest();
    }

    private static String label(Drift drift) {
        return drift.setting().solver().label();
    }

    static String verdict(Drift drift) {
        return switch (drift.kind()) {
            case FAILED -> (drift.largest() > MANY_TIMES ? "blows up" : "stops") + " at t = "
                    + Digits.few(drift.outcome().endTime()) + " s";
            case SECULAR -> (drift.end() > 0 ? "gains " : "loses ") + part(size(drift));
            case BOUNDED -> "stays within " + part(size(drift));
            case ROUNDING -> "is exact to round-off";
            case EXCHANGING -> sign(drift) + part(size(drift));
        };
    }

    /** Whether the largest error is a gain or a loss. */
    private static String sign(Drift drift) {
        return drift.extreme() > 0 ? "+" : drift.extreme() < 0 ? "\u2212" : "";
    }

    /** A part of the energy scale, in percent. */
    private static String part(double of) {
        return of >= MANY_TIMES ? two(of) + " times the energy" : two(100 * of) + " %";
    }

    private static String two(double value) {
        return Double.isFinite(value) ? Digits.few(new BigDecimal(value).round(new MathContext(2)).doubleValue())
                : Double.toString(value);
    }
}
