package particles.app.run;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.Collectors;
import particles.view.ChartData.Series;

/** The titles of a run's charts: what the numbers drawn in each show. */
final class RunFindings {
    /** Smaller parts of an energy are round-off. */
    private static final double ROUND_OFF = 1e-12;
    /** An energy that changes by less than this part of the largest one looks constant in the chart. */
    private static final double CONSTANT = 0.01;
    /** A quantity whose end is nearer to its start than this part of its largest change goes back and forth. */
    private static final double ONE_WAY = 0.5;
    /** Extents that differ by less than this are called equal. */
    private static final double EQUAL = 0.05;
    private static final int NAMED = 3;
    /** A path of fewer states has no halves that could be compared. */
    private static final int FEW_STATES = 10;
    /** Smaller factors are not told apart in a chart. */
    private static final double TINY = 0.01;

    private RunFindings() {
    }

    /** @return the total energy, in a chart in which it is the first series */
    static String energy(List<Series> drawn) {
        double[] total = drawn.get(0).y();
        if (total.length == 1) {
            return "no step was made";
        }
        double start = total[0];
        double end = total[total.length - 1];
        DoubleSummaryStatistics all = Arrays.stream(total).summaryStatistics();
        double change = Math.max(all.getMax() - start, start - all.getMin());
        double largest = drawn.stream().flatMapToDouble(series -> Arrays.stream(series.y())).map(Math::abs).max()
                .orElse(0);
        if (change <= CONSTANT * largest) {
            return "the total energy stays at " + joules(start, largest) + (change <= ROUND_OFF * largest ? ""
                    : " to " + Digits.few(100 * change / largest, 2) + " % of the largest energy");
        }
        if (Math.abs(end - start) < ONE_WAY * change) {
            return "the total energy varies from " + joules(all.getMin(), largest) + " to "
                    + joules(all.getMax(), largest);
        }
        return "the total energy " + (end > start ? "rises" : "falls") + " from " + joules(start, largest) + " to "
                + joules(end, largest);
    }

    private static String joules(double value, double largest) {
        return (Math.abs(value) <= ROUND_OFF * largest ? "0" : Digits.few(value)) + " J";
    }

    /** @return the works with the largest ends; on a logarithmic axis, which has no signs, their sizes */
    static String work(List<Series> drawn, boolean signed) {
        return drawn.stream().sorted(Comparator.comparing(series -> -Math.abs(end(series)))).limit(NAMED)
                .map(series -> series.name().replaceFirst("work: ", "") + " "
                        + (!signed ? "" : end(series) < 0 ? "\u2212" : "+") + Digits.few(Math.abs(end(series))) + " J")
                .collect(Collectors.joining(", ", "work by the end: ", ""));
    }

    private static double end(Series series) {
        return series.y()[series.y().length - 1];
    }

    /** @return the largest numerical error, in a chart of it alone; after a blow-up, most of the energy is error */
    static String error(List<Series> drawn) {
        double largest = Arrays.stream(drawn.get(0).y()).map(Math::abs).max().orElse(0);
        return "the numerical error is " + (Math.abs(largest - 1) <= EQUAL ? "as large as the energy"
                : "at most " + Digits.few(largest) + " of the energy scale");
    }

    /** @return how much larger a path in state space is in the second half of its states */
    static String path(Series path) {
        double wider = growth(path.x());
        double higher = growth(path.y());
        boolean known = path.x().length >= FEW_STATES && Double.isFinite(wider) && Double.isFinite(higher);
        String begin = "the second half of the path is ";
        return !known ? "a path of " + Summary.counted(Arrays.stream(path.x())
                .filter(Double::isFinite).count(), "state")
                : wider == 0 && higher == 0 ? "the particle is at rest in the second half of the path"
                : Math.abs(wider - 1) <= EQUAL && Math.abs(higher - 1) <= EQUAL ? begin + "as large as the first"
                : Math.abs(wider / higher - 1) <= EQUAL ? begin + times(wider) + " as large as the first"
                : begin + times(wider) + " as wide and " + times(higher) + " as high";
    }

    private static String times(double factor) {
        return (factor < TINY ? "less than " + TINY : factor > 1 / TINY ? "more than " + Math.round(1 / TINY)
                : Digits.few(factor)) + " times";
    }

    /** The extent of the second half of the values, as a multiple of the first's; NaN or infinite if there is none. */
    private static double growth(double[] values) {
        int half = values.length / 2 + 1;               // both have as many steps
        return extent(values, values.length - half, values.length) / extent(values, 0, half);
    }

    private static double extent(double[] values, int from, int to) {
        DoubleSummaryStatistics all = Arrays.stream(values, from, to).filter(Double::isFinite).summaryStatistics();
        return all.getMax() - all.getMin();
    }
}
