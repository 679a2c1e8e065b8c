package particles.output;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import particles.Memory;

/** Gives back what {@link WritingMemory} wrote. */
final class ReadingMemory implements Memory {
    private final ByteBuffer in;

    /** @param in as written, from its position on */
    ReadingMemory(ByteBuffer in) {
        this.in = in;
    }

    @Override
    public boolean isReading() {
        return true;
    }

    @Override
    public double keep(double value) {
        return Double.longBitsToDouble(in.getLong());
    }

    @Override
    public long keep(long value) {
        return in.getLong();
    }

    @Override
    public int keep(int value) {
        return in.getInt();
    }

    @Override
    public boolean keep(boolean value) {
        return in.get() != 0;
    }

    @Override
    public String keep(String value) {
        byte[] bytes = new byte[in.getInt()];
        in.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }

    @Override
    public double[] keep(double[] values, int count) {
        double[] read = new double[in.getInt()];
        for (int k = 0; k < read.length; k++) {
            read[k] = Double.longBitsToDouble(in.getLong());
        }
        return read;
    }

    @Override
    public int[] keep(int[] values, int count) {
        int[] read = new int[in.getInt()];
        for (int k = 0; k < read.length; k++) {
            read[k] = in.getInt();
        }
        return read;
    }

    @Override
    public long[] keep(long[] values, int count) {
        long[] read = new long[in.getInt()];
        for (int k = 0; k < read.length; k++) {
            read[k] = in.getLong();
        }
        return read;
    }
}
