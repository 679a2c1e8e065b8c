package particles.output.animation;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameSink;

/**
 * Writes the frames as {@code animation.gif}, which repeats for ever in simulated time. Of each frame only the changed
 * rectangle is written, with unchanged pixels transparent, and with a palette of its own. All frames are dithered by
 * the same matrix, so that the sky behind something that moves is as it was before. A pixel whose colour was not in the
 * palette is written again with the next frame.
 */
public final class GifAnimation implements FrameSink {
    /** The file's name. */
    public static final String FILE = "animation.gif";
    private static final String METADATA = "javax_imageio_gif_image_1.0";
    /** Netscape's extension: block 1, then the number of runs, 0 for ever. */
    private static final byte[] FOR_EVER = {1, 0, 0};
    /** The shortest delay (1/100 s): viewers show frames with a shorter one for a tenth of a second. */
    private static final int SHORTEST = 2;
    private static final int LONGEST = 65_535;
    /** The shades of each primary colour beside black, and the thresholds of an ordered dither between two of them. */
    private static final int BITS = 5;
    private static final int SHADES = (1 << BITS) - 1;
    private static final int COLOURS = 1 << 3 * BITS;
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
    /** The colours that a viewer shows, as pixels are dithered. */
    private final int[] shown;
    private OutputFile file;
    private MemoryCacheImageOutputStream stream;
    private ImageWriter writer;
    private int first;
    private Pending pending;

    /** A picture whose display time is not known yet: the part of it that has changed, at its place. */
    private record Pending(int index, Rectangle place, BufferedImage image) {
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
        shown = new int[this.width * this.height];
        Arrays.fill(shown, COLOURS);
    }

    /** The time of frame i in hundredths of a second; each is rounded by itself, so that errors do not add up. */
    private long due(int index) {
        return Math.round(100 * (index - first) / fps);
    }

    @Override
    public Runnable prepare(int index, int[] rgb) {
        int[] small = shrinker.shrink(rgb);
        Arrays.setAll(small, p -> dithered(small[p], BAYER[(p / width & 3) << 2 | p % width & 3]));
        return () -> add(index, small);
    }

    /** A colour of so few shades that a palette has nearly all; an even change of colour shows no bands. */
    private static int dithered(int rgb, int threshold) {
        int dithered = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            dithered = dithered << BITS | ((rgb >> shift & 255) * SHADES + 255 * threshold / BAYER.length) / 255;
        }
        return dithered;
    }

    private static int rgb(int dithered) {
        int rgb = 0;
        for (int shift = 2 * BITS; shift >= 0; shift -= BITS) {
            rgb = rgb << 8 | (dithered >> shift & SHADES) * 255 / SHADES;
        }
        return rgb;
    }

    private void add(int index, int[] small) {
        if (writer != null && due(index) - due(pending.index) < SHORTEST) {
            return;         // too fast to be shown
        }
        try {
            if (writer == null) {
                begin(index);
            } else {
                writePending(due(index) - due(pending.index));
            }
            pending = changes(index, small);
        } catch (IOException e) {
            throw new OutputException(folder.getPath().resolve(FILE), "write", e);
        }
    }

    private void begin(int index) throws IOException {
        first = index;
        file = folder.create(FILE);
        stream = new MemoryCacheImageOutputStream(file);
        writer = ImageIO.getImageWritersByFormatName("gif").next();
        writer.setOutput(stream);
        writer.prepareWriteSequence(null);          // the size is that of the first picture
    }

    /** What differs from the previous picture, as that is shown; the rest is transparent. */
    private Pending changes(int index, int[] small) {
        int[] counts = new int[COLOURS];
        Rectangle place = new Rectangle(0, 0, -1, -1);
        for (int p = 0; p < small.length; p++) {
            if (small[p] != shown[p]) {
                counts[small[p]]++;
                place.add(new Rectangle(p % width, p / width, 1, 1));
            }
        }
        if (place.isEmpty()) {
            place.setSize(1, 1);        // nothing moved, and the format has no picture of nothing
        }
        Palette palette = Palette.of(counts);
        BufferedImage image = new BufferedImage(place.width, place.height, BufferedImage.TYPE_BYTE_INDEXED,
                palette.model());
        byte[] entries = ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
        for (int k = 0; k < entries.length; k++) {
            int p = (place.y + k / place.width) * width + place.x + k % place.width;
            if (small[p] != shown[p]) {
                int entry = palette.entries[small[p]];
                entries[k] = (byte) entry;
                shown[p] = palette.colours[entry];
            }
        }
        return new Pending(index, place, image);
    }

    /**
     * The colours of a picture; entry 0 is transparent.
     *
     * @param colours the colour of each entry
     * @param entries the entry nearest to each colour of the picture
     */
    private record Palette(int[] colours, int[] entries) {
        private static final int SIZE = 256;
        /** More than the squared distance of any two colours. */
        private static final int FAR = 3 << 2 * BITS;

        /**
         * Takes again and again the colour that is most wrong without an entry of its own: by the squared distance to
         * the nearest entry, over all its pixels. So the many pixels of the sky have their colours, and a small ball
         * that is like nothing else has its own.
         *
         * @param counts the number of pixels of each colour
         */
        static Palette of(int[] counts) {
            int[] used = IntStream.range(0, COLOURS).filter(colour -> counts[colour] > 0).toArray();
            int[] colours = new int[SIZE];
            int[] entries = new int[COLOURS];
            int[] off = new int[COLOURS];
            Arrays.fill(off, FAR);
            for (int entry = 1; entry < SIZE; entry++) {
                long most = 0;
                for (int colour : used) {
                    if ((long) counts[colour] * off[colour] > most) {
                        most = (long) counts[colour] * off[colour];
                        colours[entry] = colour;
                    }
                }
                for (int colour : used) {
                    int distance = distance(colour, colours[entry]);
                    if (distance < off[colour]) {
                        off[colour] = distance;
                        entries[colour] = entry;
                    }
                }
            }
            return new Palette(colours, entries);
        }

        private static int distance(int colour, int other) {
            int red = (colour >> 2 * BITS) - (other >> 2 * BITS);
            int green = (colour >> BITS & SHADES) - (other >> BITS & SHADES);
            int blue = (colour & SHADES) - (other & SHADES);
            return red * red + green * green + blue * blue;
        }

        IndexColorModel model() {
            int[] rgb = Arrays.stream(colours).map(GifAnimation::rgb).toArray();
            return new IndexColorModel(8, SIZE, rgb, 0, false, 0, DataBuffer.TYPE_BYTE);
        }
    }

    /** Writes the pending picture, which stays under the next one, in ImageIO's "GIF Metadata Format Specification". */
    private void writePending(long hundredths) throws IOException {
        Rectangle place = pending.place;
        IIOMetadataNode root = new IIOMetadataNode(METADATA);
        add(root, "ImageDescriptor", "imageLeftPosition", place.x, "imageTopPosition", place.y, "imageWidth",
                place.width, "imageHeight", place.height, "interlaceFlag", "FALSE");
        add(root, "GraphicControlExtension", "disposalMethod", "doNotDispose", "userInputFlag", "FALSE",
                "transparentColorFlag", "TRUE", "transparentColorIndex", 0, "delayTime",
                Math.min(LONGEST, hundredths));
        if (pending.index == first) {
            IIOMetadataNode extensions = add(root, "ApplicationExtensions");
            add(extensions, "ApplicationExtension", "applicationID", "NETSCAPE", "authenticationCode", "2.0")
                    .setUserObject(FOR_EVER.clone());
        }
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(pending.image), null);
        metadata.mergeTree(METADATA, root);
        writer.writeToSequence(new IIOImage(pending.image, null, metadata), null);
        stream.flushBefore(stream.getStreamPosition());     // so that it is not all in memory
    }

    /** @param attributes names and values in turn */
    private static IIOMetadataNode add(IIOMetadataNode parent, String name, Object... attributes) {
        IIOMetadataNode node = new IIOMetadataNode(name);
        for (int k = 0; k < attributes.length; k += 2) {
            node.setAttribute((String) attributes[k], attributes[k + 1].toString());
        }
        parent.appendChild(node);
        return node;
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
