package particles.output.frames;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.files.PngEncoder;

/** Frames as numbered PNG files, {@code frames/frame-00000.png} and so on. */
public final class PngFrames implements FrameSink {
    private final OutputFolder folder;
    private final int width;
    private final int height;
    /** As many as frames are being encoded at a time. */
    private final Queue<PngEncoder> idle = new ConcurrentLinkedQueue<>();

    /**
     * @param folder the output folder
     * @param width  the width of the frames (pixels)
     * @param height the height of the frames (pixels)
     */
    public PngFrames(OutputFolder folder, int width, int height) {
        this.folder = folder;
        this.width = width;
        this.height = height;
    }

    @Override
    public Runnable prepare(int index, int[] rgb) {
        PngEncoder encoder = Optional.ofNullable(idle.poll()).orElseGet(() -> new PngEncoder(width, height));
        encoder.encode(rgb);
        return () -> {
            try (OutputFile file = folder.createFrame(index)) {
                encoder.writeTo(file);
                file.commit();
            } catch (IOException e) {
                throw new UncheckedIOException(e);      // the file's own are OutputExceptions
            }
            idle.add(encoder);
        };
    }

    @Override
    public void close() {
        idle.forEach(PngEncoder::close);
    }
}
