package particles.energy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import particles.view.Axis;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * Thins a quantity over time to a few thousand points without losing an extreme. Neighbouring samples share a bucket,
 * of which the smallest and the largest are kept with their times. When the buckets run out, each takes twice as many
 * samples. The points kept depend on the samples alone.
 */
public final class MinMaxThinning {
    private record Sample(long index, double time, double value) {
    }

    private record Bucket(Sample low, Sample high, double sum, long count) {
        Bucket and(Bucket later) {
            return new Bucket(later.low.value < low.value ? later.low : low,
                    later.high.value > high.value ? later.high : high, sum + later.sum, count + later.count);
        }
    }

    /** The number of means: a line of so many points is not dense. */
    private static final int MEANS = 32;

    private final int capacity;
    private final List<Bucket> buckets = new ArrayList<>();
    private long perBucket = 1;
    private Sample first = new Sample(-1, 0, 0);
    private Sample last = first;

    /** @param capacity the number of buckets, even; at most 2 capacity + 2 points are kept */
    public MinMaxThinning(int capacity) {
        this.capacity = capacity;
    }

    /** Adds a sample; times must not fall. */
    public void add(double time, double value) {
        last = new Sample(last.index + 1, time, value);
        first = last.index == 0 ? last : first;
        Bucket own = new Bucket(last, last, value, 1);
        int b = (int) (last.index / perBucket);
        if (b == capacity) {
            merge();
            b = buckets.size();
        }
        if (b < buckets.size()) {
            buckets.set(b, buckets.get(b).and(own));
        } else {
            buckets.add(own);
        }
    }

    /** Joins neighbouring buckets in pairs. */
    private void merge() {
        for (int b = 0; b < capacity / 2; b++) {
            buckets.set(b, buckets.get(2 * b).and(buckets.get(2 * b + 1)));
        }
        buckets.subList(capacity / 2, capacity).clear();
        perBucket *= 2;
    }

    /** @return whether there is no sample */
    public boolean isEmpty() {
        return buckets.isEmpty();
    }

    /** @return the first sample's value */
    public double getFirst() {
        return first.value;
    }

    /** @return the last sample's value */
    public double getLast() {
        return last.value;
    }

    /** @return the smallest value */
    public double smallest() {
        return buckets.stream().mapToDouble(bucket -> bucket.low.value).reduce(getFirst(), Math::min);
    }

    /** @return the largest value */
    public double largest() {
        return buckets.stream().mapToDouble(bucket -> bucket.high.value).reduce(getFirst(), Math::max);
    }

    /** @return the largest size of a value */
    double largestSize() {
        return Math.max(largest(), -smallest());
    }

    /** @return the times and the values of the points kept: the extremes of each bucket, the first and the last */
    public double[][] points() {
        Map<Long, Sample> kept = new TreeMap<>();
        Stream<Sample> extremes = buckets.stream().flatMap(bucket -> Stream.of(bucket.low, bucket.high));
        Stream.concat(isEmpty() ? Stream.of() : Stream.of(first, last), extremes)
                .forEach(sample -> kept.put(sample.index, sample));
        return new double[][] {kept.values().stream().mapToDouble(Sample::time).toArray(),
            kept.values().stream().mapToDouble(Sample::value).toArray()};
    }

    /** @return a line through the points kept, with each value shown in its own way, and the last one at its end */
    Series line(Look look, String name, DoubleUnaryOperator shown, Axis axis) {
        double[][] points = points();
        return new Series(look, name, Mark.LINE, points[0], Arrays.stream(points[1]).map(shown).toArray())
                .ending(axis);
    }

    /** @return the line, or the line of means where it would fill an area */
    Series lineOrMean(Look look, String name, DoubleUnaryOperator shown, Axis axis) {
        double[][] means = means();
        return Series.isDense(points()[1]) ? new Series(look, "mean " + name, Mark.LINE, means[0],
                Arrays.stream(means[1]).map(shown).toArray()).ending(axis) : line(look, name, shown, axis);
    }

    /** @return the times of the middle of some equal parts of all samples, and the means of the values in them */
    private double[][] means() {
        int width = Math.max(1, buckets.size() / MEANS);
        int count = buckets.size() / width;
        double[][] means = new double[2][count];
        for (int k = 0; k < count; k++) {
            List<Bucket> some = buckets.subList(k * width, (k + 1) * width);
            means[0][k] = (some.get(0).low.time + some.get(width - 1).high.time) / 2;
            means[1][k] = some.stream().mapToDouble(Bucket::sum).sum() / some.stream().mapToLong(Bucket::count).sum();
        }
        return means;
    }
}
