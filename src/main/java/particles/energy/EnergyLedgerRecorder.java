package particles.energy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import particles.ParticleSystem;
import particles.view.ChartData;
import particles.view.ChartData.Series;

/**
 * Records a run's energy ledger over time: the energy that each kind of work put in or took out, and the rest, which is
 * numerical error. Every step is recorded; curves are thinned to some thousand points, with every extreme kept.
 */
public final class EnergyLedgerRecorder extends EnergyLedger {
    private static final int BUCKETS = 1024;
    /** Work below this part of the energy scale is round-off, such as that of elastic impacts. */
    private static final double ROUNDING = 1e-12;

    private final MinMaxThinning error = new MinMaxThinning(BUCKETS);
    private final Map<String, MinMaxThinning> work = new LinkedHashMap<>();

    /** @param stride the number of steps from one point of a curve to the next, 1 or more */
    public EnergyLedgerRecorder(long stride) {
        super(stride);
    }

    @Override
    protected void record(ParticleSystem system, double[] state, double time) {
        error.add(time, getNumericalError());
        getWork().forEach((name, joules) -> work.computeIfAbsent(name, unknown -> began()).add(time, joules));
    }

    /** The first bounce may come late; until then its work was 0. */
    private MinMaxThinning began() {
        MinMaxThinning fresh = new MinMaxThinning(BUCKETS);
        for (double time : error.points()[0]) {
            fresh.add(time, 0);
        }
        return fresh;
    }

    /** @return the largest size of the work of any kind during the run (J); 0 where there is none */
    public double getLargestWork() {
        return work.values().stream().mapToDouble(MinMaxThinning::largestSize).max().orElse(0);
    }

    /** @return the times (s) and the numerical errors (J), with every extreme */
    public double[][] getNumericalErrors() {
        return error.points();
    }

    /** The numerical error at the last recorded step (J). */
    double getLatestNumericalError() {
        return error.getLast();
    }

    /** @return the largest size of the numerical error during the run (J); NaN before a run */
    public double getLargestNumericalError() {
        return error.isEmpty() ? Double.NaN : error.largestSize();
    }

    /**
     * @param scale the energy by which errors are divided (J); 0 if nothing moves
     * @param log   whether sizes are drawn on logarithmic axes, as in a run that blows up
     * @return the work of each kind, if it is more than round-off, and below it the numerical error, at the same times
     */
    public List<ChartData> charts(double scale, boolean log) {
        List<ChartData> charts = new ArrayList<>();
        List<Series> lines = new ArrayList<>();
        work.forEach((name, joules) -> {
            if (joules.largestSize() > ROUNDING * scale) {
                lines.add(joules.line("work: " + name, shown(1, log)));
            }
        });
        if (!lines.isEmpty()) {
            charts.add(new ChartData("work of physics: put in (+), taken out (\u2212)", "time (s)",
                    size(lines.size() == 1 ? lines.get(0).name().replaceFirst(" \\(.*", "") : "work", log) + " (J)",
                    false, log,
                    lines));                            // short enough for a low panel; the sign says the rest
        }
        charts.add(new ChartData("numerical error: change of energy minus the work of physics", "time (s)",
                size("numerical error", log) + " / scale", false, log,
                List.of(error.line("numerical error", shown(scale, log)))));
        return charts;
    }

    private static String size(String name, boolean log) {
        return log ? "|" + name + "|" : name;
    }

    private static DoubleUnaryOperator shown(double scale, boolean log) {
        return joules -> {
            double part = joules == 0 ? 0 : joules / scale;
            return log ? Math.abs(part) : part;
        };
    }
}
