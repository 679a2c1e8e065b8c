package particles.engine;

import java.util.Arrays;
import particles.law.AnchorMotion;
import particles.law.Particles;

/**
 * Moving anchors: particles whose motion is prescribed. They are not unknowns of the equations. The system's own state
 * and every force use their exact positions at the clock's time; a solver sees zeros in their place, which stay zeros.
 * They therefore have no truncation error, and a multistep solver finds their bits unchanged.
 */
public final class Anchors {
    private static final int STRIDE = Particles.STRIDE;

    private Anchor[] anchors = {};                      // loops over a list would allocate
    private final double[] values = new double[9];
    private double[] shown = {};
    private double[] beginning = {};
    private double[] hidden = {};

    private record Anchor(int particle, AnchorMotion motion) {
    }

    /** Adds an anchor and moves it to its position at a time. */
    public void add(int particle, AnchorMotion motion, double[] state, double time) {
        anchors = Arrays.copyOf(anchors, anchors.length + 1);
        anchors[anchors.length - 1] = new Anchor(particle, motion);
        put(time, state);
    }

    /** Writes the anchors' positions and velocities at a time into a state. */
    public void put(double time, double[] state) {
        for (Anchor anchor : anchors) {
            anchor.motion.at(time, values);
            System.arraycopy(values, 0, state, STRIDE * anchor.particle, STRIDE);
        }
    }

    /** Sets the anchors' entries of a state or derivative to 0, as solvers see them. */
    public void hide(double[] vector) {
        for (Anchor anchor : anchors) {
            int x = STRIDE * anchor.particle;
            Arrays.fill(vector, x, x + STRIDE, 0.0);
        }
    }

    /**
     * Returns the state with the anchors at their positions at a time: the array itself without anchors, otherwise a
     * copy, valid until the next call.
     */
    public double[] shownIn(double[] state, double time) {
        if (anchors.length == 0) {
            return state;
        }
        shown = copy(state, shown);
        put(time, shown);
        return shown;
    }

    /** As {@link #shownIn}, in an array of its own, for the beginning of a sub-step. */
    public double[] shownInBeginning(double[] state, double time) {
        if (anchors.length == 0) {
            return state;
        }
        beginning = copy(state, beginning);
        put(time, beginning);
        return beginning;
    }

    /**
     * Returns a solver's view of a state: the array itself without anchors, otherwise a copy, valid until the next
     * call.
     */
    public double[] hiddenIn(double[] state) {
        if (anchors.length == 0) {
            return state;
        }
        hidden = copy(state, hidden);
        hide(hidden);
        return hidden;
    }

    private static double[] copy(double[] vector, double[] used) {
        double[] copy = used.length == vector.length ? used : new double[vector.length];
        System.arraycopy(vector, 0, copy, 0, vector.length);
        return copy;
    }

    /** Writes the anchors' accelerations into a derivative. */
    public void accelerate(double time, double[] dSdt) {
        for (Anchor anchor : anchors) {
            anchor.motion.at(time, values);
            System.arraycopy(values, STRIDE, dSdt, STRIDE * anchor.particle + 3, 3);
        }
    }

    /** The shortest time in which an anchor may go and come back (s). */
    public double getShortestTime(double time) {
        double shortest = Double.POSITIVE_INFINITY;
        for (Anchor anchor : anchors) {
            shortest = Math.min(shortest, anchor.motion.getShortestTime(time));
        }
        return shortest;
    }

    /** Updates the anchors' indices after particles were removed. */
    public void reindex(int[] newIndex) {
        anchors = Arrays.stream(anchors).filter(anchor -> newIndex[anchor.particle] >= 0)
                .map(anchor -> new Anchor(newIndex[anchor.particle], anchor.motion)).toArray(Anchor[]::new);
    }

    /** The particle indices of the anchors. */
    public int[] particles() {
        return Arrays.stream(anchors).mapToInt(Anchor::particle).toArray();
    }
}
