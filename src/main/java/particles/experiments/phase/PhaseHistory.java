package particles.experiments.phase;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.Rule;
import particles.StridedRecorder;
import particles.law.Particles;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * Records the path of one particle in its state space: position against velocity along an axis, or its angle about
 * another particle against the angular velocity, after each step and again after rules changed something. Where a rule
 * changed this particle, as a bounce does, a point that is not a number cuts the line. A path of very many
 * steps has every 2nd, 3rd, ... state and the last, drawn as points, since lines between distant states would show a
 * motion that did not happen.
 */
public final class PhaseHistory extends StridedRecorder {
    private static final int MOST_STATES = 1 << 15;
    /** A path of at most this number of states shows each of them. */
    private static final int FEW = 150;
    /** Numbers of each state that is kept: position, velocity, angle, angular velocity, and 1 after a jump. */
    private static final int COLUMNS = Particles.STRIDE + 3;

    private final String id;
    private final Optional<String> about;
    private int index;
    private int pivot;
    private double angle;
    private double rate;
    private final List<double[]> path = new ArrayList<>();
    private final boolean thinned;

    /**
     * @param id    the id of the particle
     * @param about the particle about which its angle is measured, if there is one
     * @param steps the number of steps of the run
     */
    public PhaseHistory(String id, Optional<String> about, double steps) {
        super((long) Math.max(1, Math.ceil(steps / MOST_STATES)));
        thinned = steps > MOST_STATES;
        this.id = id;
        this.about = about;
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        int size = path.size();
        super.changed(system, rule);
        if (size > 0 && path.size() > size && !Arrays.equals(path.get(size), 0, Particles.STRIDE,
                path.get(size - 1), 0, Particles.STRIDE)) {
            path.get(size)[COLUMNS - 1] = 1;
        }
    }

    /** Adds a state. Births and deaths may move the particle to another index; when it is removed, its path ends. */
    @Override
    protected void record(ParticleSystem system, double[] state, double time) {
        Particles particles = system.getParticles();
        index = find(particles, id, index);
        pivot = about.isPresent() ? find(particles, about.get(), pivot) : index;
        if (index == particles.count() || pivot == particles.count()) {
            return;
        }
        if (about.isPresent()) {
            turn(state, Particles.STRIDE * index, Particles.STRIDE * pivot);
        }
        double[] kept = Arrays.copyOfRange(state, Particles.STRIDE * index, Particles.STRIDE * index + COLUMNS);
        kept[Particles.STRIDE] = angle;
        kept[Particles.STRIDE + 1] = rate;
        kept[COLUMNS - 1] = 0;
        path.add(kept);
    }

    /** @return the index of a particle, usually the same as before; the number of particles if it was removed */
    private static int find(Particles particles, String id, int before) {
        return before < particles.count() && particles.id(before).equals(id) ? before
                : IntStream.range(0, particles.count()).filter(i -> particles.id(i).equals(id)).findFirst()
                .orElse(particles.count());
    }

    /** Finds the angle of the line from the pivot, within half a turn of the angle before, and its rate. */
    private void turn(double[] state, int particle, int pivot) {
        double x = state[particle] - state[pivot];
        double y = state[particle + 1] - state[pivot + 1];
        double vx = state[particle + 3] - state[pivot + 3];
        double vy = state[particle + 4] - state[pivot + 4];
        angle += StrictMath.IEEEremainder(StrictMath.atan2(x, -y) - angle, 2 * Math.PI);
        rate = (x * vy - y * vx) / (x * x + y * y);
    }

    /** @return the axis along which the particle went farthest; x if it did not move */
    Coordinate widestAxis() {
        return Coordinate.DIRECTIONS.stream().reduce((widest, axis) -> range(axis) > range(widest) ? axis : widest)
                .orElseThrow();
    }

    private double range(Coordinate axis) {
        DoubleSummaryStatistics values = range(column(axis.ordinal()));
        return values.getMax() - values.getMin();
    }

    /** @return the range of values, without those where a path is cut */
    static DoubleSummaryStatistics range(double[] values) {
        return Arrays.stream(values).filter(value -> !Double.isNaN(value)).summaryStatistics();
    }

    private double[] column(int entry) {
        return path.stream().flatMapToDouble(state -> state[COLUMNS - 1] == 1 && !thinned
                ? DoubleStream.of(Double.NaN, state[entry]) : DoubleStream.of(state[entry])).toArray();
    }

    /**
     * @param axis the component of the motion
     * @param look the look of the path
     * @param name the name of the path, such as its solver's
     * @return the path, cut at jumps, and its first and last state once more as marks of their own
     * @throws IllegalStateException if no run with this particle was observed
     */
    public Chart chart(Coordinate axis, Look look, String name) {
        if (path.isEmpty()) {
            throw new IllegalStateException("no run with a particle '" + id + "' was observed");
        }
        double[] x = column(axis == Coordinate.ANGLE ? Particles.STRIDE : axis.ordinal());
        double[] v = column(axis == Coordinate.ANGLE ? Particles.STRIDE + 1 : axis.ordinal() + 3);
        String whose = " of '" + id + "'" + (axis == Coordinate.ANGLE ? " about '" + about.orElseThrow() + "'" : "");
        Mark mark = thinned ? Mark.POINTS : path.size() <= FEW ? Mark.LINE_AND_POINTS : Mark.LINE;
        return new Chart(axis.position(whose), axis.velocity(whose), List.of(new Series(look, name, mark, x, v),
                start(x[0], v[0]), Series.point(Look.MARK, "end", Mark.POINTS, x[x.length - 1], v[x.length - 1])));
    }

    /** @return the mark of the start of a path */
    static Series start(double x, double v) {
        return Series.point(Look.MARK.variant(1), "start", Mark.POINTS, x, v);
    }
}
