package particles.output.frames;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import particles.output.files.OutputFile;
import particles.output.files.PngEncoder;

/** Keeps the last frame of a run and writes it as one PNG picture when the run is over. */
public final class LastFrame implements FrameSink {
    private final Path file;
    private final int width;
    private final int height;
    private int[] last = {};

    /**
     * @param file   the picture; its folder exists
     * @param width  the width of the frames (pixels)
     * @param height the height of the frames (pixels)
     */
    public LastFrame(Path file, int width, int height) {
        this.file = file;
        this.width = width;
        this.height = height;
    }

    @Override
    public Runnable prepare(int index, int[] rgb) {
        return () -> last = rgb.clone();
    }

    @Override
    public void close() {
        if (last.length == 0) {
            return;
        }
        PngEncoder encoder = new PngEncoder(width, height);
        try (OutputFile picture = new OutputFile(file, OutputFile.ON_DISK, () -> { })) {
            encoder.write(last, picture);
            picture.commit();
        } catch (IOException e) {
            throw new UncheckedIOException(e);      // the file's own are OutputExceptions
        } finally {
            encoder.close();
        }
        last = new int[0];
    }
}
