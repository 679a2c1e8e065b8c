package particles.experiments.energy;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.energy.EnergyDrift.Kind;

/** One sentence about a comparison: each solver's energy error with its size, the worst first. */
final class DriftHeadline {
    /** The largest number of solvers named; the others, which are better, are summed up in the last place. */
    private static final int NAMED = 4;
    /** From ten times the energy on, a percentage is hard to read. */
    private static final double MANY_TIMES = 10;

    private DriftHeadline() {
    }

    static String of(Comparison comparison) {
        List<Drift> drifts = comparison.drifts().stream().sorted(WORST_FIRST).toList();
        boolean exchanges = drifts.stream().anyMatch(drift -> drift.kind() == Kind.EXCHANGING);
        int named = drifts.size() <= NAMED + 1 ? drifts.size() : NAMED;
        Stream<String> others = named == drifts.size() ? Stream.empty()
                : Stream.of("the other " + (drifts.size() - named) + " are off by at most "
                + part(size(drifts.get(named))));
        String parts = Stream.concat(drifts.stream().limit(named).map(drift -> label(drift) + " " + verdict(drift)),
                others).collect(Collectors.joining("; "));
        return comparison.scene() + (exchanges ? ", numerical energy error: " : ": ") + parts
                + (comparison.equalWork() ? " (equal evaluations)" : "");
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
