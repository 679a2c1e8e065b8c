package particles.experiments.phase;

import java.util.Arrays;
import java.util.List;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.law.Particles;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * The path of one particle in its state space: position against velocity along an axis, after each step and again after
 * rules changed something, so that a bounce is a vertical line. A very long path is thinned to every 2nd, 4th, ...
 * state, and then drawn as points, since lines between distant states would show a motion that was none.
 */
public final class PhaseHistory implements Observer {
    private static final int CAPACITY = 1 << 15;
    /** A path of no more states than this shows each of them. */
    private static final int FEW = 150;

    private final String id;
    private int index;
    private double[] path = new double[Particles.STRIDE * 256];     // position and velocity of each state kept
    private int count;
    private long every = 1;
    private long states;

    /** @param id which particle */
    public PhaseHistory(String id) {
        this.id = id;
    }

    @Override
    public void started(ParticleSystem system) {
        add(system, system.getOwnState());
    }

    @Override
    public void moved(Motion motion) {
        add(motion.getSystem(), motion.getEndState());
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        add(system, system.getOwnState());
    }

    /** Particles that come and go may move this one to another index; once it is gone, its path has ended. */
    private void add(ParticleSystem system, double[] state) {
        Particles particles = system.getParticles();
        if (index >= particles.count() || !particles.id(index).equals(id)) {
            index = 0;
            while (index < particles.count() && !particles.id(index).equals(id)) {
                index++;
            }
            if (index == particles.count()) {
                return;
            }
        }
        if (states++ % every != 0) {
            return;
        }
        if (count == CAPACITY) {
            halve();
        }
        if (Particles.STRIDE * count == path.length) {
            path = Arrays.copyOf(path, 2 * path.length);
        }
        System.arraycopy(state, Particles.STRIDE * index, path, Particles.STRIDE * count++, Particles.STRIDE);
    }

    /** Of the states kept, whose number is even, every second one stays: the next one to come is due as well. */
    private void halve() {
        for (int k = 0; k < count; k += 2) {
            System.arraycopy(path, Particles.STRIDE * k, path, Particles.STRIDE * (k / 2), Particles.STRIDE);
        }
        count /= 2;
        every *= 2;
    }

    /** @return the axis along which the particle went farthest; x if it did not move */
    public Axis widestAxis() {
        Axis widest = Axis.X;
        for (Axis axis : Axis.values()) {
            if (range(column(axis.ordinal())) > range(column(widest.ordinal()))) {
                widest = axis;
            }
        }
        return widest;
    }

    private static double range(double[] values) {
        return Arrays.stream(values).max().orElse(0) - Arrays.stream(values).min().orElse(0);
    }

    private double[] column(int entry) {
        double[] values = new double[count];
        for (int k = 0; k < count; k++) {
            values[k] = path[Particles.STRIDE * k + entry];
        }
        return values;
    }

    /**
     * @param axis  which component of the motion
     * @param title of the chart, such as the scene and its solver
     * @return the path, and its first and last state once more as marks of their own
     * @throws IllegalStateException if no run with this particle was observed
     */
    public ChartData chart(Axis axis, String title) {
        if (count == 0) {
            throw new IllegalStateException("no run with a particle '" + id + "' was observed");
        }
        double[] x = column(axis.ordinal());
        double[] v = column(axis.ordinal() + 3);
        Mark mark = every > 1 ? Mark.POINTS : count <= FEW ? Mark.LINE_AND_POINTS : Mark.LINE;
        return new ChartData(title, "position " + axis.symbol() + " of '" + id + "' (m)",
                "velocity v" + axis.symbol() + " of '" + id + "' (m/s)", false, false,
                List.of(new Series("path", mark, x, v),
                        new Series("start", Mark.POINTS, new double[] {x[0]}, new double[] {v[0]}),
                        new Series("end", Mark.POINTS, new double[] {x[count - 1]}, new double[] {v[count - 1]})));
    }
}
