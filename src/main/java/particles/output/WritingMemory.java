package particles.output;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import particles.Memory;

/** Writes what passes through as bytes, numbers with all their bits. */
final class WritingMemory implements Memory {
    private final DataOutputStream out;

    WritingMemory(DataOutputStream out) {
        this.out = out;
    }

    private interface Action {
        void run() throws IOException;
    }

    private static void attempt(Action action) {
        try {
            action.run();
        } catch (IOException e) {
            throw new UncheckedIOException(e);          // a file's own troubles are OutputExceptions
        }
    }

    @Override
    public boolean isReading() {
        return false;
    }

    @Override
    public double keep(double value) {
        attempt(() -> out.writeLong(Double.doubleToRawLongBits(value)));
        return value;
    }

    @Override
    public long keep(long value) {
        attempt(() -> out.writeLong(value));
        return value;
    }

    @Override
    public int keep(int value) {
        attempt(() -> out.writeInt(value));
        return value;
    }

    @Override
    public boolean keep(boolean value) {
        attempt(() -> out.writeBoolean(value));
        return value;
    }

    @Override
    public String keep(String value) {
        byte[] bytes = value.getBytes(StandardCharsets.UTF_8);
        attempt(() -> {
            out.writeInt(bytes.length);
            out.write(bytes);
        });
        return value;
    }

    @Override
    public double[] keep(double[] values, int count) {
        attempt(() -> {
            out.writeInt(count);
            for (int k = 0; k < count; k++) {
                out.writeLong(Double.doubleToRawLongBits(values[k]));
            }
        });
        return values;
    }

    @Override
    public int[] keep(int[] values, int count) {
        attempt(() -> {
            out.writeInt(count);
            for (int k = 0; k < count; k++) {
                out.writeInt(values[k]);
            }
        });
        return values;
    }

    @Override
    public long[] keep(long[] values, int count) {
        attempt(() -> {
            out.writeInt(count);
            for (int k = 0; k < count; k++) {
                out.writeLong(values[k]);
            }
        });
        return values;
    }
}
