package particles.output.frames;

import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.files.PngEncoder;

/**
 * Frames as numbered PNG files, {@code frames/frame-00000.png} and so on.
 *
 * @param folder the output folder
 * @param width  the width of the frames (pixels)
 * @param height the height of the frames (pixels)
 */
public record PngFrames(OutputFolder folder, int width, int height) implements FrameSink {

    @Override
    public Runnable prepare(int index, int[] rgb) {
        byte[] png = PngEncoder.file(width, height, rgb);
        return () -> {
            try (OutputFile file = folder.createFrame(index)) {
                file.write(png, 0, png.length);
                file.commit();
            }
        };
    }
}
