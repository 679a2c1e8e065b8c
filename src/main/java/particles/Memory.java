package particles;

/**
 * The way to a checkpoint and back: every value that a run has to remember passes through. While a checkpoint is written,
 * each call gives back what it was given; while one is read, what was given to the same call when it was written. So one
 * method describes both ways, and they cannot differ:
 * <pre>
 *   time = memory.keep(time);
 * </pre>
 */
public interface Memory {

    /** @return true while a checkpoint is read, false while one is written */
    boolean isReading();

    /**
     * @param value a number
     * @return the number to go on with, bit for bit
     */
    double keep(double value);

    /**
     * @param value a number
     * @return the number to go on with
     */
    long keep(long value);

    /**
     * @param value a number
     * @return the number to go on with
     */
    int keep(int value);

    /**
     * @param value a truth
     * @return the truth to go on with
     */
    boolean keep(boolean value);

    /**
     * @param value a text
     * @return the text to go on with
     */
    String keep(String value);

    /**
     * @param values holds numbers, perhaps more than count
     * @param count  how many there are; when reading, how many there were
     * @return an array to go on with: the same one when writing, a new one of exactly {@code count} when reading
     */
    double[] keep(double[] values, int count);

    /**
     * @param values holds numbers, perhaps more than count
     * @param count  how many there are; when reading, how many there were
     * @return an array to go on with: the same one when writing, a new one of exactly {@code count} when reading
     */
    int[] keep(int[] values, int count);

    /**
     * @param values holds numbers, perhaps more than count
     * @param count  how many there are; when reading, how many there were
     * @return an array to go on with: the same one when writing, a new one of exactly {@code count} when reading
     */
    long[] keep(long[] values, int count);
}
