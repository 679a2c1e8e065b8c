package particles.output.frames;

import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.files.PngEncoder;

/**
 * A receiver of drawn frames, such as a film. Several threads draw, so it takes a frame in two parts: what needs no
 * other frame, such as compressing, by the thread that drew it, and the rest in the order of the frames.
 */
@FunctionalInterface
public interface FrameSink extends AutoCloseable {

    /**
     * Prepares a frame; several threads may call it at a time.
     *
     * @param index its number; frame i shows time i / fps
     * @param rgb   the pixels, 0xRRGGBB row by row from the top; valid until the returned action has run
     * @return the rest of the work, such as writing; run by one thread at a time in the order of the frames
     * @throws OutputException if it cannot be written; so does the action
     */
    Runnable prepare(int index, int[] rgb);

    /**
     * Completes the output after the last frame.
     *
     * @throws OutputException if it cannot be
     */
    @Override
    default void close() {
        // a receiver that needs no end
    }

    /** @return a sink that writes pictures of this size (pixels), {@code frames/frame-00000.png} and so on */
    static FrameSink png(OutputFolder folder, int width, int height) {
        return (index, rgb) -> {
            byte[] png = PngEncoder.file(width, height, rgb);
            return () -> folder.createFrame(index, "png").writeWhole(png);
        };
    }
}
