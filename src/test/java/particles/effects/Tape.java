package particles.effects;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import particles.Memory;

/** Remembers what passes through, and gives it back in the same order once it is {@link #rewind rewound}. */
final class Tape implements Memory {
    private final Deque<Object> values = new ArrayDeque<>();
    private boolean reading;

    void rewind() {
        reading = true;
    }

    boolean isEmpty() {
        return values.isEmpty();
    }

    @Override
    public boolean isReading() {
        return reading;
    }

    private <T> T pass(T value, Class<T> type) {
        if (reading) {
            return type.cast(values.remove());
        }
        values.add(value);
        return value;
    }

    @Override
    public double keep(double value) {
        return pass(value, Double.class);
    }

    @Override
    public long keep(long value) {
        return pass(value, Long.class);
    }

    @Override
    public int keep(int value) {
        return pass(value, Integer.class);
    }

    @Override
    public boolean keep(boolean value) {
        return pass(value, Boolean.class);
    }

    @Override
    public String keep(String value) {
        return pass(value, String.class);
    }

    @Override
    public double[] keep(double[] given, int count) {
        return reading ? pass(given, double[].class) : keepCopy(given, Arrays.copyOf(given, count));
    }

    @Override
    public int[] keep(int[] given, int count) {
        return reading ? pass(given, int[].class) : keepCopy(given, Arrays.copyOf(given, count));
    }

    @Override
    public long[] keep(long[] given, int count) {
        return reading ? pass(given, long[].class) : keepCopy(given, Arrays.copyOf(given, count));
    }

    private <T> T keepCopy(T given, T copy) {
        values.add(copy);
        return given;
    }
}
