package particles.engine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import particles.law.AnchorMotion;
import particles.law.Particles;

/**
 * The fixed particles that follow a given motion. Where they are is known at all times, so that they are no unknowns of
 * the equations that a solver solves: in the system's own state and in every force they are exactly where their motions
 * are at the clock's time, and what a solver sees of them is zeros that stay zeros. No error of a step gets into them,
 * and a solver that remembers where its last step ended finds the same bits there.
 */
public final class Anchors {
    private static final int STRIDE = Particles.STRIDE;

    private final List<Anchor> anchors = new ArrayList<>();
    private final double[] values = new double[9];
    private double[] shown = {};
    private double[] hidden = {};
    private double[] direction = {};

    private record Anchor(int particle, AnchorMotion motion) {
    }

    /** Adds one and puts it where its motion begins. */
    public void add(int particle, AnchorMotion motion, double[] state, double time) {
        anchors.add(new Anchor(particle, motion));
        motion.at(time, values);
        System.arraycopy(values, 0, state, STRIDE * particle, STRIDE);
    }

    /** Puts them where they are at a time: positions and velocities, into a state. */
    public void put(double time, double[] state) {
        for (int a = 0; a < anchors.size(); a++) {
            anchors.get(a).motion().at(time, values);
            System.arraycopy(values, 0, state, STRIDE * anchors.get(a).particle(), STRIDE);
        }
    }

    /** Makes a solver's view of a state, or of its derivative or a direction: zeros where anchors that move stand. */
    public void hide(double[] vector) {
        for (int a = 0; a < anchors.size(); a++) {
            int x = STRIDE * anchors.get(a).particle();
            Arrays.fill(vector, x, x + STRIDE, 0.0);
        }
    }

    /**
     * A state with the anchors where they are at a time: the array itself where none moves, or a copy, valid until the
     * next.
     */
    public double[] shownIn(double[] state, double time, int n) {
        if (anchors.isEmpty()) {
            return state;
        }
        shown = copy(state, n, shown);
        put(time, shown);
        return shown;
    }

    /** A solver's view of a state: the array itself where no anchor moves, or a copy, valid until the next. */
    public double[] hiddenIn(double[] state, int n) {
        if (anchors.isEmpty()) {
            return state;
        }
        hidden = copy(state, n, hidden);
        hide(hidden);
        return hidden;
    }

    /** A direction without what nothing depends on: as {@link #hiddenIn}, while that copy is still in use. */
    public double[] freePartOf(double[] direction, int n) {
        if (anchors.isEmpty()) {
            return direction;
        }
        this.direction = copy(direction, n, this.direction);
        hide(this.direction);
        return this.direction;
    }

    private static double[] copy(double[] vector, int n, double[] used) {
        double[] copy = used.length == n ? used : new double[n];
        System.arraycopy(vector, 0, copy, 0, n);
        return copy;
    }

    /** Puts the given accelerations into a derivative. */
    public void accelerate(double time, double[] dSdt) {
        for (int a = 0; a < anchors.size(); a++) {
            anchors.get(a).motion().at(time, values);
            System.arraycopy(values, STRIDE, dSdt, STRIDE * anchors.get(a).particle() + 3, 3);
        }
    }

    public void reindex(int[] newIndex) {
        anchors.removeIf(anchor -> newIndex[anchor.particle()] < 0);
        anchors.replaceAll(anchor -> new Anchor(newIndex[anchor.particle()], anchor.motion()));
    }

    /** The indices of the particles. */
    public int[] particles() {
        return anchors.stream().mapToInt(Anchor::particle).toArray();
    }
}
