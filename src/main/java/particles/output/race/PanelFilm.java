package particles.output.race;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.FrameSink;

/** The frames of one run, compressed in memory until those of all other runs are there too. */
final class PanelFilm implements FrameSink {
    private final FrameRenderer renderer;
    private final FrameObserver observer;
    private final List<byte[]> packed = new ArrayList<>();

    /**
     * @param stage  the settings of the frames
     * @param width  the width of the frames (pixels)
     * @param height the height of the frames (pixels)
     * @param rate   the number of frames per second of simulated time (1/s)
     */
    PanelFilm(FrameSetup stage, int width, int height, double rate) {
        renderer = new FrameRenderer(stage, width, height, Optional.empty());
        observer = new FrameObserver(renderer, rate, List.of(this));
    }

    /** @return draws the run; closed, it waits for the frames of a run that ended early */
    FrameObserver getObserver() {
        return observer;
    }

    /** @return the renderer of its frames */
    FrameRenderer getRenderer() {
        return renderer;
    }

    /** @return the number of frames */
    int count() {
        return packed.size();
    }

    /**
     * @param index the index of a frame; after the last frame, the last one counts
     * @param rgb   receives its pixels
     */
    void get(int index, int[] rgb) {
        byte[] frame = packed.get(Math.min(index, packed.size() - 1));
        try (InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(frame))) {
            ByteBuffer.wrap(in.readAllBytes()).asIntBuffer().get(rgb);
        } catch (IOException e) {
            throw new UncheckedIOException("a frame that was packed here cannot be unpacked", e);
        }
    }

    /** The frames are read when the drawing threads have ended. */
    @Override
    public Runnable prepare(int index, int[] rgb) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * rgb.length);
        bytes.asIntBuffer().put(rgb);
        ByteArrayOutputStream frame = new ByteArrayOutputStream();
        Deflater fast = new Deflater(Deflater.BEST_SPEED);
        try (DeflaterOutputStream out = new DeflaterOutputStream(frame, fast)) {
            out.write(bytes.array());
        } catch (IOException e) {
            throw new UncheckedIOException("memory takes all that is written", e);
        } finally {
            fast.end();
        }
        return () -> packed.add(frame.toByteArray());
    }
}
