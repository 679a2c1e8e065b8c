package particles.energy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * Thins a quantity over time to a few thousand points without losing an extreme. Neighbouring samples share a bucket,
 * of which the smallest and the largest are kept with their times. When the buckets run out, each takes twice as many
 * samples. The points kept depend on the samples alone.
 */
public final class MinMaxThinning {
    private record Sample(long index, double time, double value) {
    }

    private final Sample[] low;
    private final Sample[] high;
    private int buckets;
    private long perBucket = 1;
    private long samples;
    private Sample first;
    private double lastTime;
    private double last;

    /** @param capacity the number of buckets, even; at most 2 capacity + 2 points are kept */
    public MinMaxThinning(int capacity) {
        low = new Sample[capacity];
        high = new Sample[capacity];
    }

    /** Adds a sample; times must not fall. */
    public void add(double time, double value) {
        lastTime = time;
        last = value;
        boolean begins = samples == perBucket * buckets;
        if (begins && buckets == low.length) {
            merge();
        }
        buckets += begins ? 1 : 0;
        int b = buckets - 1;
        if (begins || value < low[b].value || value > high[b].value) {
            Sample sample = new Sample(samples, time, value);
            first = samples == 0 ? sample : first;
            low[b] = begins || value < low[b].value ? sample : low[b];
            high[b] = begins || value > high[b].value ? sample : high[b];
        }
        samples++;
    }

    /** Joins neighbouring buckets in pairs. */
    private void merge() {
        for (int b = 0; b < buckets; b += 2) {
            low[b / 2] = low[b + 1].value < low[b].value ? low[b + 1] : low[b];
            high[b / 2] = high[b + 1].value > high[b].value ? high[b + 1] : high[b];
        }
        buckets /= 2;
        perBucket *= 2;
    }

    /** @return whether there is no sample */
    public boolean isEmpty() {
        return samples == 0;
    }

    /** @return the first sample's value */
    public double first() {
        return isEmpty() ? 0 : first.value;
    }

    /** @return the last sample's value */
    public double getLast() {
        return last;
    }

    /** @return the smallest value */
    public double smallest() {
        return Arrays.stream(low, 0, buckets).mapToDouble(Sample::value).reduce(first(), Math::min);
    }

    /** @return the largest value */
    public double largest() {
        return Arrays.stream(high, 0, buckets).mapToDouble(Sample::value).reduce(first(), Math::max);
    }

    /** @return the largest size of a value */
    double largestSize() {
        return Math.max(largest(), -smallest());
    }

    /** @return the times and the values of the points kept: the extremes of each bucket, the first and the last */
    public double[][] points() {
        List<Sample> kept = new ArrayList<>(isEmpty() ? List.of() : List.of(first));
        for (int b = 0; b < buckets; b++) {
            boolean lowFirst = low[b].index <= high[b].index;
            for (Sample next : lowFirst ? List.of(low[b], high[b]) : List.of(high[b], low[b])) {
                if (next.index > kept.get(kept.size() - 1).index) {
                    kept.add(next);
                }
            }
        }
        if (!isEmpty() && kept.get(kept.size() - 1).index < samples - 1) {
            kept.add(new Sample(samples - 1, lastTime, last));
        }
        return new double[][] {kept.stream().mapToDouble(Sample::time).toArray(),
            kept.stream().mapToDouble(Sample::value).toArray()};
    }

    /** @return a line through the points kept, with each value shown in its own way */
    Series line(String name, DoubleUnaryOperator shown) {
        double[][] points = points();
        return new Series(name, Mark.LINE, points[0], Arrays.stream(points[1]).map(shown).toArray());
    }
}
