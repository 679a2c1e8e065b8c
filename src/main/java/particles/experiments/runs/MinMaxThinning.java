package particles.experiments.runs;

import java.util.Arrays;

/**
 * Thins a quantity over time to a few thousand points without losing an extreme. Neighbouring samples share a bucket,
 * of which the smallest and the largest are kept with their times. When the buckets run out, each takes twice as many
 * samples. The points kept depend on the samples alone.
 */
public final class MinMaxThinning {
    private final long[] lowIndex;
    private final double[] lowTime;
    private final double[] low;
    private final long[] highIndex;
    private final double[] highTime;
    private final double[] high;
    private int buckets;
    private long perBucket = 1;
    private long samples;
    private double firstTime;
    private double first;
    private double lastTime;
    private double last;

    /** @param capacity the number of buckets, even; at most 2 capacity + 2 points are kept */
    public MinMaxThinning(int capacity) {
        lowIndex = new long[capacity];
        lowTime = new double[capacity];
        low = new double[capacity];
        highIndex = new long[capacity];
        highTime = new double[capacity];
        high = new double[capacity];
    }

    /** Adds a sample; times must not fall. */
    public void add(double time, double value) {
        if (samples == 0) {
            firstTime = time;
            first = value;
        }
        lastTime = time;
        last = value;
        if (samples == perBucket * buckets) {
            if (buckets == low.length) {
                merge();
            }
            lowIndex[buckets] = highIndex[buckets] = samples;
            lowTime[buckets] = highTime[buckets] = time;
            low[buckets] = high[buckets] = value;
            buckets++;
        } else {
            int b = buckets - 1;
            if (value < low[b]) {
                lowIndex[b] = samples;
                lowTime[b] = time;
                low[b] = value;
            }
            if (value > high[b]) {
                highIndex[b] = samples;
                highTime[b] = time;
                high[b] = value;
            }
        }
        samples++;
    }

    /** Two neighbours become one. */
    private void merge() {
        for (int b = 0; b < buckets; b += 2) {
            int lower = low[b + 1] < low[b] ? b + 1 : b;
            int higher = high[b + 1] > high[b] ? b + 1 : b;
            lowIndex[b / 2] = lowIndex[lower];
            lowTime[b / 2] = lowTime[lower];
            low[b / 2] = low[lower];
            highIndex[b / 2] = highIndex[higher];
            highTime[b / 2] = highTime[higher];
            high[b / 2] = high[higher];
        }
        buckets /= 2;
        perBucket *= 2;
    }

    /** @return whether no sample was added */
    public boolean isEmpty() {
        return samples == 0;
    }

    /** @return the value of the first sample */
    public double first() {
        return first;
    }

    /** @return the value of the last sample */
    public double last() {
        return last;
    }

    /** @return the smallest value */
    public double smallest() {
        double smallest = first;
        for (int b = 0; b < buckets; b++) {
            smallest = Math.min(smallest, low[b]);
        }
        return smallest;
    }

    /** @return the largest value */
    public double largest() {
        double largest = first;
        for (int b = 0; b < buckets; b++) {
            largest = Math.max(largest, high[b]);
        }
        return largest;
    }

    /** @return the points kept, in the order in which they came, with the first and the last: times and values */
    public double[][] points() {
        double[][] points = new double[2][2 * buckets + 2];
        int n = 0;
        long taken = -1;
        for (int b = 0; b < buckets; b++) {
            boolean lowFirst = lowIndex[b] <= highIndex[b];
            if (b == 0 && Math.min(lowIndex[0], highIndex[0]) > 0) {
                n = put(points, n, firstTime, first);
            }
            n = lowFirst ? put(points, n, lowTime[b], low[b]) : put(points, n, highTime[b], high[b]);
            if (lowIndex[b] != highIndex[b]) {
                n = lowFirst ? put(points, n, highTime[b], high[b]) : put(points, n, lowTime[b], low[b]);
            }
            taken = Math.max(lowIndex[b], highIndex[b]);
        }
        if (taken < samples - 1) {
            n = put(points, n, lastTime, last);
        }
        return new double[][] {Arrays.copyOf(points[0], n), Arrays.copyOf(points[1], n)};
    }

    private static int put(double[][] points, int n, double time, double value) {
        points[0][n] = time;
        points[1][n] = value;
        return n + 1;
    }
}
