package particles.output.frames;

import java.io.IOException;
import java.io.UncheckedIOException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.files.PngEncoder;

/** Frames as numbered PNG files, {@code frames/frame-00000.png} and so on. */
public final class PngFrames implements FrameSink {
    private final OutputFolder folder;
    private final PngEncoder encoder;

    /**
     * @param folder the output folder
     * @param width  the width of the frames (pixels)
     * @param height the height of the frames (pixels)
     */
    public PngFrames(OutputFolder folder, int width, int height) {
        this.folder = folder;
        encoder = new PngEncoder(width, height);
    }

    @Override
    public void add(int index, int[] rgb) {
        try (OutputFile file = folder.createFrame(index)) {
            encoder.write(rgb, file);
            file.commit();
        } catch (IOException e) {
            throw new UncheckedIOException(e);      // the file's own are OutputExceptions
        }
    }

    @Override
    public void close() {
        encoder.close();
    }
}
