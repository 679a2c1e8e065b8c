package particles.output.frames;

import particles.output.files.OutputException;

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
     * No frame follows: what came so far is completed.
     *
     * @throws OutputException if it cannot be
     */
    @Override
    void close();
}
