package particles.output;

/** Where drawn frames go. Called by one thread, which need not be the simulation's. */
public interface FrameSink extends AutoCloseable {

    /**
     * Takes a frame.
     *
     * @param index its number; frame i shows time i / fps
     * @param rgb   the pixels, 0xRRGGBB row by row from the top; valid during this call only
     * @throws OutputException if it cannot be written
     */
    void add(int index, int[] rgb);

    /**
     * The run is continued: takes frames again that an earlier run of the program has made.
     *
     * @param first   the first of them
     * @param next    the number of the frame after the last of them
     * @param earlier what they were
     */
    default void resume(int first, int next, EarlierFrames earlier) {
        for (int index = first; index < next; index++) {
            add(index, earlier.read(index));
        }
    }

    /**
     * No frame follows: what came so far is completed.
     *
     * @throws OutputException if it cannot be
     */
    @Override
    void close();
}
