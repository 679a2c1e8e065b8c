package particles.output.race;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameSetup;
import particles.output.frames.FrameSink;
import particles.output.painters.FrameState;

/** The frames of one run, compressed in memory until those of all other runs are there too. */
final class PanelFilm implements Observer, AutoCloseable {
    private final FrameSetup stage;
    private final int width;
    private final int height;
    private final FrameRenderer renderer;
    private final FrameObserver frames;
    private final List<byte[]> packed = new ArrayList<>();
    private int[] backdrop = {};

    /**
     * @param stage  the settings of the frames
     * @param width  the width of the frames (pixels)
     * @param height the height of the frames (pixels)
     * @param rate   the number of frames per second of simulated time (1/s)
     */
    PanelFilm(FrameSetup stage, int width, int height, double rate) {
        this.stage = stage;
        this.width = width;
        this.height = height;
        renderer = new FrameRenderer(stage, width, height, Optional.empty());
        frames = new FrameObserver(renderer, rate, List.of(new Packer()));
    }

    @Override
    public void started(ParticleSystem system) {
        FrameState state = new FrameState();
        state.take(system.getOwnState(), system.getParticles().count(), system.getTime());
        state.takeStructure(system, true);
        backdrop = new FrameRenderer(stage, width, height, Optional.empty()).renderBackdrop(state);
        frames.started(system);
    }

    @Override
    public double getNextTime() {
        return frames.getNextTime();
    }

    @Override
    public void moved(Motion motion) {
        frames.moved(motion);
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        frames.changed(system, rule);
    }

    @Override
    public void finished(ParticleSystem system) {
        frames.finished(system);
    }

    /** Waits until the frames of a run that ended early are drawn. */
    @Override
    public void close() {
        frames.close();
    }

    /** @return the number of frames */
    int count() {
        return packed.size();
    }

    /** @return the picture without anything that moves */
    int[] getBackdrop() {
        return backdrop;
    }

    /** @return colours that later frames may have */
    int[] importantColours() {
        return renderer.importantColours();
    }

    /**
     * @param index the index of a frame; after the last frame, the last one counts
     * @param rgb   receives its pixels
     */
    void get(int index, int[] rgb) {
        Inflater inflater = new Inflater();
        inflater.setInput(packed.get(Math.min(index, packed.size() - 1)));
        byte[] bytes = new byte[Integer.BYTES * rgb.length];
        try {
            for (int n = 0; n < bytes.length;) {
                n += inflater.inflate(bytes, n, bytes.length - n);
            }
        } catch (DataFormatException e) {
            throw new IllegalStateException("a frame that was packed here cannot be unpacked", e);
        } finally {
            inflater.end();
        }
        ByteBuffer.wrap(bytes).asIntBuffer().get(rgb);
    }

    /** Takes frames from the drawing threads; they are read when those have ended. */
    private final class Packer implements FrameSink {
        @Override
        public Runnable prepare(int index, int[] rgb) {
            ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * rgb.length);
            bytes.asIntBuffer().put(rgb);
            Deflater deflater = new Deflater(Deflater.BEST_SPEED);
            deflater.setInput(bytes);
            deflater.finish();
            byte[] out = new byte[bytes.capacity() / 4];
            int n = 0;
            while (!deflater.finished()) {
                if (n == out.length) {
                    out = Arrays.copyOf(out, 2 * n);
                }
                n += deflater.deflate(out, n, out.length - n);
            }
            deflater.end();
            byte[] frame = Arrays.copyOf(out, n);
            return () -> packed.add(frame);
        }

        @Override
        public void close() {
            // the frames are kept
        }
    }
}
