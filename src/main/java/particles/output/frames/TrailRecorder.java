package particles.output.frames;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.stream.IntStream;
import particles.law.Particles;
import particles.output.painters.FrameState.TrailSample;

/** Records the positions of particles at regular times and at impacts, for as long as trails are visible. */
public final class TrailRecorder {
    /** The number of samples from one frame to the next, and the most in a trail, enough for a smooth line. */
    private static final int PER_FRAME = 4;
    private static final int MOST = 1000;
    /** The largest number of samples at impacts, as a part of the regular ones. */
    private static final double CORNERS = 0.25;

    private final double duration;
    private final double interval;
    private final int mostWithCorners;
    private final Deque<TrailSample> samples = new ArrayDeque<>();
    private double next;

    /**
     * @param duration the duration of trails (s); 0 if there are none
     * @param fps      frames a second
     */
    public TrailRecorder(double duration, double fps) {
        this.duration = duration;
        interval = Math.max(1 / (PER_FRAME * fps), duration / MOST);
        mostWithCorners = (int) Math.ceil((1 + CORNERS) * duration / interval);
        next = duration > 0 ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }

    /** @return the time of the next sample (s); infinity if there are no trails */
    public double getNextTime() {
        return next;
    }

    /**
     * Takes a sample if it is due.
     *
     * @param state     a state in the layout of the system's state
     * @param particles the particles that it is of
     */
    public void take(double time, double[] state, Particles particles) {
        if (time < next) {
            return;
        }
        String[] ids = IntStream.range(0, particles.count()).mapToObj(particles::id).toArray(String[]::new);
        if (!samples.isEmpty() && Arrays.equals(ids, samples.peekLast().ids())) {
            ids = samples.peekLast().ids();             // one array for as long as none is born or removed
        }
        float[] places = new float[3 * ids.length];
        for (int k = 0; k < places.length; k++) {
            places[k] = (float) state[k / 3 * Particles.STRIDE + k % 3];
        }
        samples.addLast(new TrailSample(time, places, ids));
        while (samples.peekFirst().time() < time - duration - interval) {
            samples.removeFirst();
        }
        next = time + interval;
    }

    /**
     * Takes a sample where paths turn, as at an impact, unless the trail has many of these already. Without it, a
     * bounce would be cut off between two regular samples.
     */
    public void takeCorner(double time, double[] state, Particles particles) {
        if (samples.size() < mostWithCorners) {
            next = time;
            take(time, state, particles);
        }
    }

    /** @return the samples so far, the latest first */
    public List<TrailSample> samples() {
        List<TrailSample> latestFirst = new ArrayList<>(samples);
        Collections.reverse(latestFirst);
        return latestFirst;
    }
}
