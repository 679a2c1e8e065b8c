package particles.output.animation;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameSink;

/**
 * Writes the frames as {@code animation.gif}, which repeats for ever in simulated time. Of each frame only the changed
 * rectangle is written, with unchanged pixels transparent. The first frames wait until there are enough of them for a
 * palette, which serves all others that have similar colours. Even areas are dithered, alike in all frames, so that the
 * sky shows no bands, and behind something that moves is as it was before.
 */
public final class GifAnimation implements FrameSink {
    /** The file's name. */
    public static final String FILE = "animation.gif";
    /** The shortest delay (1/100 s): viewers show frames with a shorter one for a tenth of a second. */
    private static final int SHORTEST = 2;
    private static final int LONGEST = 65_535;
    /** The memory of the frames that wait for the palette (pixels). */
    private static final int MOST_WAITING = 8_000_000;
    /** A change of colour by so little is not worth its bytes; it is also the largest that the dither makes. */
    private static final int UNSEEN = 3;
    /** A pixel is in an even area if so many on either side have its colour. Dithered cloth takes half as much more. */
    private static final int EVEN = 4;
    private static final int[] BAYER = {
        0, 8, 2, 10,
        12, 4, 14, 6,
        3, 11, 1, 9,
        15, 7, 13, 5};

    private final OutputFolder folder;
    private final double fps;
    private final Shrinker shrinker;
    private final int width;
    private final int height;
    private final Deque<Frame> waiting = new ArrayDeque<>();
    private int[] shown = {};
    private Palette palette;
    private OutputFile file;
    private MemoryCacheImageOutputStream stream;
    private ImageWriter writer;

    /** A picture that is not written yet: how long it is shown becomes known by the next one. */
    private record Frame(int index, int[] rgb) {
    }

    /**
     * @param folder      the output folder
     * @param frameWidth  the width of the frames (pixels)
     * @param frameHeight the height of the frames (pixels)
     * @param width       the largest width of the animation (pixels); the frames are shrunk by a whole number
     * @param fps         frames a second
     */
    public GifAnimation(OutputFolder folder, int frameWidth, int frameHeight, int width, double fps) {
        this.folder = folder;
        this.fps = fps;
        shrinker = new Shrinker(frameWidth, frameHeight, (frameWidth + width - 1) / width);
        this.width = shrinker.width;
        this.height = shrinker.height;
    }

    /** The time of frame i in hundredths of a second; each is rounded by itself, so that errors do not add up. */
    private long due(int index) {
        return Math.round(100 * index / fps);
    }

    @Override
    public Runnable prepare(int index, int[] rgb) {
        int[] small = shrinker.shrink(rgb);
        int[] dithered = small.clone();
        Arrays.setAll(dithered, p -> isEven(small, p) ? dithered(small[p], BAYER[(p / width & 3) << 2 | p % width & 3])
                : small[p]);
        return () -> add(new Frame(index, dithered));
    }

    private static boolean isEven(int[] rgb, int pixel) {
        for (int p = Math.max(0, pixel - EVEN); p <= Math.min(rgb.length - 1, pixel + EVEN); p++) {
            if (rgb[p] != rgb[pixel]) {
                return false;
            }
        }
        return true;
    }

    /** A colour that is lighter or darker by up to {@link #UNSEEN}: it may have another one of the palette. */
    private static int dithered(int rgb, int threshold) {
        int change = UNSEEN * (2 * threshold - BAYER.length + 1) / (BAYER.length - 1);
        int dithered = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            dithered |= Math.max(0, Math.min(255, (rgb >> shift & 255) + change)) << shift;
        }
        return dithered;
    }

    private void add(Frame frame) {
        if (!waiting.isEmpty() && due(frame.index) - due(waiting.getLast().index) < SHORTEST) {
            return;         // too fast to be shown
        }
        waiting.add(frame);
        if (writer != null || waiting.size() > MOST_WAITING / frame.rgb.length) {
            try {
                writeAllButLast();
            } catch (IOException e) {
                throw new OutputException(folder.getPath().resolve(FILE), "write", e);
            }
        }
    }

    private void writeAllButLast() throws IOException {
        if (writer == null) {
            palette = Palette.of(waiting.stream().map(Frame::rgb).toList(), width);
            file = folder.create(FILE);
            stream = new MemoryCacheImageOutputStream(file);
            writer = ImageIO.getImageWritersByFormatName("gif").next();
            writer.setOutput(stream);
            writer.prepareWriteSequence(null);          // size and palette are those of the first picture
        }
        while (waiting.size() > 1) {
            Frame frame = waiting.remove();
            write(frame, due(waiting.getFirst().index) - due(frame.index));
        }
    }

    /** Writes what differs from the picture that is shown; the rest is transparent. */
    private void write(Frame frame, long hundredths) throws IOException {
        boolean first = shown.length == 0;
        if (first) {
            shown = new int[frame.rgb.length];
        }
        Rectangle place = new Rectangle(0, 0, -1, -1);
        int[] changed = IntStream.range(0, frame.rgb.length)
                .filter(p -> first || Palette.distance(frame.rgb[p], shown[p]) > UNSEEN).toArray();
        for (int p : changed) {
            place.add(new Rectangle(p % width, p / width, 1, 1));
        }
        if (place.isEmpty()) {
            place.setSize(1, 1);        // nothing moved, and the format has no picture of nothing
        }
        if (!palette.fits(frame.rgb, changed)) {
            palette = Palette.of(List.of(frame.rgb), width);
        }
        BufferedImage image = palette.picture(place.width, place.height);
        for (int p : changed) {
            palette.set(image, p % width - place.x, p / width - place.y, frame.rgb[p]);
            shown[p] = frame.rgb[p];
        }
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), null);
        GifMetadata.describeFrame(metadata, place, palette.transparent(), (int) Math.min(LONGEST, hundredths), first);
        writer.writeToSequence(new IIOImage(image, null, metadata), null);
        stream.flushBefore(stream.getStreamPosition());     // so that it is not all in memory
    }

    /** Ends the file; the last frame stays as long as the others do. */
    @Override
    public void close() {
        if (waiting.isEmpty()) {
            return;
        }
        try {
            writeAllButLast();
            try (OutputFile whole = file) {
                try (MemoryCacheImageOutputStream out = stream) {
                    Frame last = waiting.remove();
                    write(last, Math.max(SHORTEST, due(last.index + 1) - due(last.index)));
                    writer.endWriteSequence();
                    out.flush();
                } finally {
                    writer.dispose();
                }
                whole.commit();
            }
        } catch (IOException e) {
            throw new OutputException(folder.getPath().resolve(FILE), "write", e);
        }
    }
}
