package particles.output.animation;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameSink;

/**
 * Writes the frames as {@code animation.gif}, which repeats for ever in simulated time. Of each frame only the changed
 * rectangle is written, with unchanged pixels transparent. The palette comes from the first frame and the colours that
 * may come later.
 */
public final class GifAnimation implements FrameSink {
    /** The file's name. */
    public static final String FILE = "animation.gif";
    private static final int TRANSPARENT = 255;
    /** The shortest delay (1/100 s): viewers show frames with a shorter one for a tenth of a second. */
    private static final int SHORTEST = 2;
    private static final int LONGEST = 65_535;

    private final OutputFolder folder;
    private final int[] importantColours;
    private final double fps;
    private final Shrinker shrinker;
    private final int width;
    private final int height;
    private int[] before = {};
    private final byte[] shown;
    private final byte[] current;
    private Palette palette;
    private IndexColorModel colours;
    private OutputFile file;
    private MemoryCacheImageOutputStream stream;
    private ImageWriter writer;
    private int first;
    private Pending pending;

    /** A picture whose display time is not known yet: the part of it that has changed, at its place. */
    private record Pending(int index, Rectangle place, BufferedImage image) {
    }

    /**
     * @param folder   the output folder
     * @param renderer draws the frames
     * @param width    the largest width of the animation (pixels); the frames are shrunk by a whole number
     * @param fps      frames a second
     */
    public GifAnimation(OutputFolder folder, FrameRenderer renderer, int width, double fps) {
        this(folder, renderer.getWidth(), renderer.getHeight(), renderer.importantColours(), width, fps);
    }

    /** @param importantColours colours that later frames may have */
    public GifAnimation(OutputFolder folder, int frameWidth, int frameHeight, int[] importantColours, int width,
            double fps) {
        this.folder = folder;
        this.importantColours = importantColours.clone();
        this.fps = fps;
        shrinker = new Shrinker(frameWidth, frameHeight, (frameWidth + width - 1) / width);
        this.width = shrinker.width;
        this.height = shrinker.height;
        shown = new byte[this.width * this.height];
        current = new byte[this.width * this.height];
    }

    /** The time of frame i in hundredths of a second; each is rounded by itself, so that errors do not add up. */
    private long due(int index) {
        return Math.round(100 * (index - first) / fps);
    }

    @Override
    public Runnable prepare(int index, int[] rgb) {
        int[] small = shrinker.shrink(rgb);
        return () -> add(index, small);
    }

    private void add(int index, int[] small) {
        if (writer != null && due(index) - due(pending.index) < SHORTEST) {
            return;         // too fast to be shown
        }
        try {
            boolean first = writer == null;
            if (first) {
                begin(index, small);
            } else {
                writePending(due(index) - due(pending.index));
            }
            for (int y = 0, p = 0; y < height; y++) {
                for (int x = 0; x < width; x++, p++) {
                    if (first || small[p] != before[p]) {
                        current[p] = (byte) palette.index(small[p], x, y);
                    }
                }
            }
            pending = changes(index);
            before = small;
        } catch (IOException e) {
            throw new OutputException(folder.getPath().resolve(FILE), "write", e);
        }
    }

    private void begin(int index, int[] small) throws IOException {
        first = index;
        palette = Palette.of(small, importantColours, TRANSPARENT);
        int[] table = Arrays.copyOf(palette.getColours(), TRANSPARENT + 1);
        colours = new IndexColorModel(8, table.length, table, 0, false, TRANSPARENT, DataBuffer.TYPE_BYTE);
        file = folder.create(FILE);
        stream = new MemoryCacheImageOutputStream(file);
        writer = ImageIO.getImageWritersByFormatName("gif").next();
        writer.setOutput(stream);
        writer.prepareWriteSequence(null);          // the size and the palette are those of the first picture
        Arrays.fill(shown, (byte) TRANSPARENT);
    }

    /** What differs from the previous picture. */
    private Pending changes(int index) {
        Rectangle place = new Rectangle(0, 0, -1, -1);
        for (int p = 0; p < current.length; p++) {
            if (current[p] != shown[p]) {
                place.add(new Rectangle(p % width, p / width, 1, 1));
            }
        }
        if (place.isEmpty()) {
            place.setSize(1, 1);        // nothing moved, and the format has no picture of nothing
        }
        BufferedImage image = new BufferedImage(place.width, place.height, BufferedImage.TYPE_BYTE_INDEXED, colours);
        byte[] pixels = new byte[place.width * place.height];
        for (int k = 0; k < pixels.length; k++) {
            int p = (place.y + k / place.width) * width + place.x + k % place.width;
            pixels[k] = current[p] == shown[p] ? (byte) TRANSPARENT : current[p];
            shown[p] = current[p];
        }
        image.getRaster().setDataElements(0, 0, place.width, place.height, pixels);
        return new Pending(index, place, image);
    }

    private void writePending(long hundredths) throws IOException {
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(pending.image), null);
        GifMetadata.describeFrame(metadata, pending.place, TRANSPARENT, (int) Math.min(LONGEST, hundredths),
                pending.index == first);
        writer.writeToSequence(new IIOImage(pending.image, null, metadata), null);
        stream.flushBefore(stream.getStreamPosition());     // so that it is not all in memory
    }

    /** Ends the file; the last frame stays as long as the others do. */
    @Override
    public void close() {
        if (writer == null) {
            return;
        }
        try (OutputFile whole = file) {
            try (MemoryCacheImageOutputStream out = stream) {
                writePending(Math.max(SHORTEST, due(pending.index + 1) - due(pending.index)));
                writer.endWriteSequence();
                out.flush();
            } finally {
                writer.dispose();
            }
            whole.commit();
        } catch (IOException e) {
            throw new OutputException(folder.getPath().resolve(FILE), "write", e);
        }
    }
}
