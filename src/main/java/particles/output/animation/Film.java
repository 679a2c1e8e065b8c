package particles.output.animation;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import org.jcodec.codecs.h264.H264Encoder;
import org.jcodec.codecs.h264.encode.RateControl;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.codecs.h264.io.model.SliceType;
import org.jcodec.codecs.h264.io.model.VUIParameters;
import org.jcodec.common.Codec;
import org.jcodec.common.MuxerTrack;
import org.jcodec.common.VideoCodecMeta;
import org.jcodec.common.VideoEncoder.EncodedFrame;
import org.jcodec.common.io.SeekableByteChannel;
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
        encoder = new Encoder();
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
        muxer = MP4Muxer.createMP4Muxer(new Channel(), Brand.MP4);
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

    /** The library's H.264 encoder, with one quality for all frames and the colour standard named in the stream. */
    private static final class Encoder extends H264Encoder {
        /**
         * The quantiser, from 0 to 51; each 6 double the steps of colours. At 20 the sky has a tint in places, at 12 it
         * has none.
         */
        private static final int QUANTISER = 12;
        /**
         * Numbers in H.264's tables of primaries, transfer curves and matrices (Annex E): BT.709, and BT.601's matrix.
         */
        private static final int BT709 = 1;
        private static final int BT601 = 6;
        private static final int UNSPECIFIED_FORMAT = 5;

        Encoder() {
            super(new SteadyQuality());
        }

        /** Adds the colour standard; without it, players guess it by the size of the picture. */
        @Override
        public SeqParameterSet initSPS(Size size) {
            SeqParameterSet parameters = super.initSPS(size);
            int blocks = (parameters.picWidthInMbsMinus1 + 1) * (parameters.picHeightInMapUnitsMinus1 + 1);
            // Table A-1: frame size by level
            parameters.levelIdc = blocks <= 8192 ? 40 : blocks <= 36_864 ? 51 : 60;
            VUIParameters usability = new VUIParameters();
            usability.videoSignalTypePresentFlag = true;
            usability.videoFormat = UNSPECIFIED_FORMAT;
            usability.videoFullRangeFlag = false;
            usability.colourDescriptionPresentFlag = true;
            usability.colourPrimaries = BT709;
            usability.transferCharacteristics = BT709;
            usability.matrixCoefficients = BT601;
            parameters.vuiParams = usability;
            return parameters;
        }

        /** Rate control with constant quality: frames of a still scene are small, those of a wild one large. */
        private static final class SteadyQuality implements RateControl {
            @Override
            public int startPicture(Size size, int maxSize, SliceType sliceType) {
                return QUANTISER;
            }

            @Override
            public int initialQpDelta() {
                return 0;
            }

            @Override
            public int accept(int bits) {
                return 0;
            }
        }
    }

    /**
     * An output file as the channel of the film library: it is extended at its end, and its header is completed at
     * last.
     */
    private final class Channel implements SeekableByteChannel {
        private long size;
        private long position;

        @Override
        public int write(ByteBuffer source) {
            byte[] bytes = new byte[source.remaining()];
            source.get(bytes);
            if (position == size) {
                file.write(bytes, 0, bytes.length);
            } else if (position + bytes.length <= size) {
                file.overwrite(position, bytes);
            } else {
                throw new IllegalStateException("bytes at " + position + " reach over the end at " + size);
            }
            position += bytes.length;
            size = Math.max(size, position);
            return bytes.length;
        }

        @Override
        public long position() {
            return position;
        }

        @Override
        public SeekableByteChannel setPosition(long to) {
            position = to;
            return this;
        }

        @Override
        public long size() {
            return size;
        }

        @Override
        public int read(ByteBuffer target) throws IOException {
            throw new IOException("a film that is being written is not read");
        }

        @Override
        public SeekableByteChannel truncate(long length) throws IOException {
            throw new IOException("a film that is being written is not shortened");
        }

        @Override
        public boolean isOpen() {
            return true;
        }

        /** Does nothing: the file is closed by its owner. */
        @Override
        public void close() {
            // nothing of its own
        }
    }
}
