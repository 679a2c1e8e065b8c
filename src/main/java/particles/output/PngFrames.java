package particles.output;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/** Frames as numbered PNG files, {@code frames/frame-00000.png} and so on. */
public final class PngFrames implements FrameSink, EarlierFrames {
    private final OutputFolder folder;
    private final int width;
    private final int height;
    private final PngEncoder encoder;

    /**
     * @param folder where they go
     * @param width  of the frames (pixels)
     * @param height of the frames (pixels)
     */
    public PngFrames(OutputFolder folder, int width, int height) {
        this.folder = folder;
        this.width = width;
        this.height = height;
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

    /** Its files are there. */
    @Override
    public void resume(int first, int next, EarlierFrames earlier) {
        for (int index = first; index < next; index++) {
            if (!Files.isRegularFile(folder.frameFile(index))) {
                throw new OutputException(folder.frameFile(index), "continue after", "it is not there any more", null);
            }
        }
    }

    @Override
    public int[] read(int index) {
        Path file = folder.frameFile(index);
        try {
            BufferedImage image = ImageIO.read(file.toFile());
            if (image == null || image.getWidth() != width || image.getHeight() != height) {
                throw new OutputException(file, "read", "it is no picture of this run", null);
            }
            int[] rgb = image.getRGB(0, 0, width, height, null, 0, width);
            for (int p = 0; p < rgb.length; p++) {
                rgb[p] &= 0xffffff;
            }
            return rgb;
        } catch (IOException e) {
            throw new OutputException(file, "read", e);
        }
    }

    @Override
    public void close() {
        encoder.close();
    }
}
