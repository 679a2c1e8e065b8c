package particles.energy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import particles.ParticleSystem;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;

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
    public List<Chart> charts(double scale, boolean log) {
        List<Chart> charts = new ArrayList<>();
        Axis joules = new Axis(log ? "|work|" : "work", "J", log);
        List<Series> lines = work.entrySet().stream().filter(kind -> kind.getValue().largestSize() > ROUNDING * scale)
                .map(kind -> kind.getValue().line(isDriving(kind.getKey()) ? Look.DRIVEN : Look.WORK, kind.getKey(),
                        shown(1, log), joules)).toList();
        if (!lines.isEmpty()) {
            charts.add(new Chart(Axis.TIME, joules, lines).named("work"));
        }
        Axis part = new Axis(log ? "|error| / scale" : "error / scale", "", log);
        charts.add(new Chart(Axis.TIME, part, List.of(error.line(Look.ERROR, "numerical error", shown(scale, log),
                part))).named("numerical-error"));
        return charts;
    }

    private static DoubleUnaryOperator shown(double scale, boolean log) {
        return joules -> {
            double part = joules == 0 ? 0 : joules / scale;
            return log ? Math.abs(part) : part;
        };
    }
}
