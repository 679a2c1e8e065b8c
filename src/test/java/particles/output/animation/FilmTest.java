package particles.output.animation;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jcodec.codecs.h264.H264Decoder;
import org.jcodec.common.DemuxerTrack;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.common.io.SeekableByteChannel;
import org.jcodec.common.model.Packet;
import org.jcodec.common.model.Picture;
import org.jcodec.common.model.Size;
import org.jcodec.containers.mp4.demuxer.MP4Demuxer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.output.files.Disk;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;

/** A film read back has the frames that were written. */
class FilmTest {
    private static final int W = 100;
    private static final int H = 58;
    private static final int[] STRIPES = {0x2050c0, 0x90c040, 0x808080, 0xffffff};

    @TempDir
    Path top;

    private record Read(Size size, double duration, List<Picture> pictures, List<Double> times) {
    }

    /** A red square on blue, green, grey and white stripes that moves 2 pixels to the right per frame. */
    private static int[] frame(int width, int height, int index) {
        int[] rgb = new int[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                boolean square = x >= 2 * index && x < 2 * index + 24 && y >= 16 && y < 40;
                rgb[y * width + x] = square ? 0xd02010 : STRIPES[y / 16 % 4];
            }
        }
        return rgb;
    }

    private void write(int width, int height, double fps, int first, int count) {
        try (OutputFolder folder = OutputFolder.open(top, Film.FILE); Film film = new Film(folder, width, height,
                fps)) {
            for (int k = 0; k < count; k++) {
                film.prepare(first + k, frame(width, height, k)).run();
            }
        }
    }

    private Read read() throws IOException {
        try (SeekableByteChannel channel = NIOUtils.readableFileChannel(top.resolve(Film.FILE).toString());
                MP4Demuxer demuxer = MP4Demuxer.createMP4Demuxer(channel)) {
            DemuxerTrack track = demuxer.getVideoTrack();
            H264Decoder decoder = H264Decoder.createH264DecoderFromCodecPrivate(track.getMeta().getCodecPrivate());
            Size size = track.getMeta().getVideoCodecMeta().getSize();
            List<Picture> pictures = new ArrayList<>();
            List<Double> times = new ArrayList<>();
            for (Packet packet = track.nextFrame(); packet != null; packet = track.nextFrame()) {
                int width = size.getWidth() + 15 & ~15;
                int height = size.getHeight() + 15 & ~15;
                byte[][] planes = {new byte[width * height], new byte[width * height / 4],
                        new byte[width * height / 4]};
                pictures.add(decoder.decodeFrame(ByteBuffer.wrap(NIOUtils.toArray(packet.getData())), planes));
                times.add(packet.getPtsD());
            }
            return new Read(size, track.getMeta().getTotalDuration(), pictures, times);
        }
    }

    /**
     * Red, green and blue in floating point, from the standard's definition (BT.601, 2.5).
     */
    private static int[] rgb(Picture picture, int x, int y) {
        double luma = ((picture.getPlaneData(0)[y * picture.getPlaneWidth(0) + x] + 128) - 16) / 219.0;
        int chroma = y / 2 * picture.getPlaneWidth(1) + x / 2;
        double blue = luma + 1.772 * picture.getPlaneData(1)[chroma] / 224.0;
        double red = luma + 1.402 * picture.getPlaneData(2)[chroma] / 224.0;
        double green = (luma - 0.299 * red - 0.114 * blue) / 0.587;
        return new int[] {(int) Math.round(255 * red), (int) Math.round(255 * green), (int) Math.round(255 * blue)};
    }

    @Test
    void sizeFramesTimesAndColoursReadBack() throws IOException {
        write(W, H, 25, 0, 30);
        Read film = read();
        assertEquals(W, film.size().getWidth());
        assertEquals(H, film.size().getHeight());
        assertEquals(30, film.pictures().size());
        assertEquals(1.2, film.duration(), 1e-9);
        double worst = 0;
        double sum = 0;
        int count = 0;
        for (int k = 0; k < 30; k++) {
            assertEquals(k / 25.0, film.times().get(k), 1e-9);
            int[] drawn = frame(W, H, k);
            for (int y = 0; y < H; y++) {
                for (int x = 0; x < W; x++) {
                    int[] seen = rgb(film.pictures().get(k), x, y);
                    for (int c = 0; c < 3; c++) {
                        int error = Math.abs(seen[c] - (drawn[y * W + x] >> 16 - 8 * c & 255));
                        worst = Math.max(worst, error);
                        sum += error;
                        count++;
                    }
                }
            }
        }
        // of 255; the quantiser of the encoder leaves them: measured 0.23 and 4
        assertBelow(1, sum / count);
        assertBelow(8, worst);
    }

    /**
     * A fractional frame rate accumulates no error, an odd last row and column are left out, a run may begin with any
     * frame, and a slow film is as long as the run.
     */
    @ParameterizedTest
    @CsvSource({"1, 29.97, 7, 50", "0, 0.01, 0, 3"})
    void oddSizesAndRatesAreFilmedToo(int odd, double rate, int first, int count) throws IOException {
        write(W + odd, H + odd, rate, first, count);
        Read film = read();
        assertEquals(List.of(W, H, count),
                List.of(film.size().getWidth(), film.size().getHeight(), film.pictures().size()));
        double tick = 1 / (512 * rate);
        assertEquals(count / rate, film.duration(), tick);
        assertEquals((count - 1) / rate, film.times().get(count - 1), tick);
    }

    /** A film appears only when it is complete, and a failed one leaves nothing. */
    @Test
    void aFilmIsWholeOrNotThere() throws IOException {
        try (OutputFolder folder = OutputFolder.open(top, Film.FILE)) {
            Film film = new Film(folder, W, H, 25);
            film.prepare(0, frame(W, H, 0)).run();
            assertFalse(Files.exists(top.resolve(Film.FILE)));
            film.close();
            assertTrue(Files.exists(top.resolve(Film.FILE)));
        }
        Files.delete(top.resolve(Film.FILE));
        Disk full = file -> file.getFileName().toString().contains("film") ? new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        } : Disk.REAL.create(file);
        OutputException e = assertThrows(OutputException.class, () -> {
            try (OutputFolder folder = OutputFolder.open(top, full, Film.FILE);
                    Film film = new Film(folder, W, H, 25)) {
                film.prepare(0, frame(W, H, 0)).run();
            }
        });
        assertHas(e.getMessage(), "film.mp4", "the disk is full");
        assertFalse(e.getMessage().contains("\n"));
        try (var files = Files.list(top)) {
            assertTrue(files.noneMatch(file -> file.getFileName().toString().contains("film")));
        }
    }
}
