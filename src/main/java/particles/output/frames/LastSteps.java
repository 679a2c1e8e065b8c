package particles.output.frames;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import particles.ParticleSystem;
import particles.Rule;
import particles.StridedRecorder;
import particles.law.Particles;
import particles.law.Vector3;
import particles.output.raster.CameraProjection;
import particles.view.Camera;

/**
 * Keeps the last steps of a run, so that a blow-up can be shown one step at a time: it often takes fewer steps than
 * there are between two frames. Nothing is kept once all moving particles have left the picture.
 */
public final class LastSteps extends StridedRecorder {
    /** More steps than this would take too long to watch, one at a time. */
    private static final int MOST_STEPS = 12;
    /** All kept states together have at most this many numbers, 8 MB; of a system too large for two, none is kept. */
    private static final int MOST_NUMBERS = 1_000_000;

    /**
     * The state after a step.
     *
     * @param time  the time (s)
     * @param state the positions and velocities, in the layout of the system's state
     */
    record Step(double time, double[] state) {
    }

    private final CameraProjection view;
    private final Deque<Step> steps = new ArrayDeque<>();
    private boolean gone;

    /**
     * @param camera the camera of the run
     * @param width  the width of the pictures (pixels)
     * @param height the height of the pictures (pixels)
     */
    public LastSteps(Camera camera, int width, int height) {
        view = new CameraProjection(camera, width, height);
    }

    /**
     * Replaces the last state. The one before the rule needs no picture of its own, and one of other particles cannot
     * be drawn.
     */
    @Override
    public void changed(ParticleSystem system, Rule rule) {
        if (!steps.isEmpty() && !gone) {
            steps.removeLast();
        }
        super.changed(system, rule);
    }

    @Override
    protected void record(ParticleSystem system, double[] state, double time) {
        int numbers = system.getStateSize();            // the system's own array may be longer
        int most = Math.min(MOST_STEPS, MOST_NUMBERS / Math.max(1, numbers));
        if (most < 2) {
            return;
        }
        if (!steps.isEmpty() && steps.peekLast().state.length != numbers) {
            steps.clear();
        }
        boolean outside = system.getParticles().free().noneMatch(i ->
                view.isInPicture(Vector3.at(state, Particles.STRIDE * i)));
        if (outside && gone) {
            return;
        }
        gone = outside;
        boolean full = steps.size() >= most;
        double[] copy = full ? steps.removeFirst().state : new double[numbers];
        System.arraycopy(state, 0, copy, 0, numbers);
        steps.addLast(new Step(time, copy));
    }

    /** @return the steps, the first one first; the last one may be the first at which nothing was in the picture */
    List<Step> steps() {
        return List.copyOf(steps);
    }
}
