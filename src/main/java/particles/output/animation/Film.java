package particles.output.animation;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import org.jcodec.codecs.h264.H264Encoder;
import org.jcodec.common.Codec;
import org.jcodec.common.MuxerTrack;
import org.jcodec.common.VideoCodecMeta;
import org.jcodec.common.VideoEncoder.EncodedFrame;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Packet;
import org.jcodec.common.model.Packet.FrameType;
import org.jcodec.common.model.Picture;
import org.jcodec.common.model.Size;
import org.jcodec.containers.mp4.Brand;
import org.jcodec.containers.mp4.muxer.MP4Muxer;
import org.jcodec.scale.RgbToYuv420p;
import org.jcodec.scale.Transform;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameSink;

/**
 * Writes the frames as a film, {@code film.mp4}, in simulated time: H.264 in an MP4 file, which browsers and players
 * show. It is written frame by frame. The format halves the resolution of colours and has even sizes only, so an odd
 * last column or row is dropped.
 */
public final class Film implements FrameSink {
    /** The file's name. */
    public static final String FILE = "film.mp4";
    /** The clock's ticks in a frame; the format counts up to 2^32 ticks, more than 8 million frames. */
    private static final int TICKS = 512;
    private static final int KEY_FRAMES_SECONDS = 2;
    /** The distance over which the encoder searches for motion (pixels); its default, 16, takes twice the time. */
    private static final int SEARCH_RANGE = 4;
    private static final Transform RGB_TO_YUV = new RgbToYuv420p();

    private final OutputFolder folder;
    private final double fps;
    private final int rowLength;
    private final int width;
    private final int height;
    private final H264Encoder encoder;
    private final int ticksPerSecond;
    private ByteBuffer buffer;
    private OutputFile file;
    private MP4Muxer muxer;
    private MuxerTrack track;
    private int first;

    /**
     * @param folder the output folder
     * @param width  the width of the frames (pixels)
     * @param height the height of the frames (pixels)
     * @param fps    frames a second
     */
    public Film(OutputFolder folder, int width, int height, double fps) {
        this.folder = folder;
        this.fps = fps;
        rowLength = width;
        this.width = width & ~1;
        this.height = height & ~1;
        encoder = new FilmEncoder();
        encoder.setKeyInterval((int) Math.max(1, Math.min(250, Math.round(KEY_FRAMES_SECONDS * fps))));
        encoder.setMotionSearchRange(SEARCH_RANGE);
        ticksPerSecond = (int) Math.max(1, Math.round(TICKS * fps));
    }

    /** The time of frame i in ticks; each is rounded by itself, so that errors do not add up. */
    private long due(int index) {
        return Math.round(ticksPerSecond * ((index - first) / fps));
    }

    /** The frame as the library reads it: a byte each of red, green and blue, less 128. */
    private Picture picture(int[] rgb) {
        Picture picture = Picture.create(width, height, ColorSpace.RGB);
        byte[] bytes = picture.getPlaneData(0);
        for (int p = 0, k = 0; k < bytes.length; p++) {
            int pixel = rgb[p / width * rowLength + p % width];
            for (int shift = 16; shift >= 0; shift -= 8) {
                bytes[k++] = (byte) ((pixel >> shift & 255) - 128);
            }
        }
        return picture;
    }

    @Override
    public Runnable prepare(int index, int[] rgb) {
        Picture picture = Picture.create(width, height, ColorSpace.YUV420J);
        RGB_TO_YUV.transform(picture(rgb), picture);
        return () -> add(index, picture);
    }

    private void add(int index, Picture picture) {
        try {
            if (muxer == null) {
                begin(index, picture);
            }
            buffer.clear();
            EncodedFrame frame = encoder.encodeFrame(picture, buffer);
            track.addFrame(Packet.createPacket(frame.getData(), due(index), ticksPerSecond, due(index + 1) - due(index),
                    index - first, frame.isKeyFrame() ? FrameType.KEY : FrameType.INTER, null));
        } catch (IOException e) {
            throw new UncheckedIOException(e);      // the file's own are OutputExceptions
        }
    }

    private void begin(int index, Picture picture) throws IOException {
        first = index;
        buffer = ByteBuffer.allocate(encoder.estimateBufferSize(picture));
        file = folder.create(FILE);
        muxer = MP4Muxer.createMP4Muxer(new FilmChannel(file), Brand.MP4);
        track = muxer.addVideoTrack(Codec.H264, VideoCodecMeta.createSimpleVideoCodecMeta(
                new Size(width, height), ColorSpace.YUV420J));
    }

    /** Ends the file; the last frame stays as long as the others do. */
    @Override
    public void close() {
        if (muxer == null) {
            return;
        }
        try (OutputFile whole = file) {
            muxer.finish();
            whole.commit();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
