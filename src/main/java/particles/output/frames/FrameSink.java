package particles.output.frames;

import particles.output.files.OutputException;

/** A receiver of drawn frames, such as a film. It is called by one thread, which need not be the simulation's. */
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
     * Completes the output after the last frame.
     *
     * @throws OutputException if it cannot be
     */
    @Override
    void close();
}
