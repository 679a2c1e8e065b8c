package particles.experiments.phase;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import particles.ParticleSystem;
import particles.Rule;
import particles.StridedRecorder;
import particles.experiments.runs.FollowedParticle;
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
    /** The numbers of each state: a coordinate each, and their velocities. */
    private static final int COORDINATES = Coordinate.values().length;
    private static final double[] CUT = DoubleStream.generate(() -> Double.NaN).limit(2 * COORDINATES).toArray();

    private final String id;
    private final Optional<String> about;
    private final FollowedParticle particle;
    private final Optional<FollowedParticle> pivot;
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
        particle = new FollowedParticle(id);
        pivot = about.map(FollowedParticle::new);
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        int size = path.size();
        super.changed(system, rule);
        if (!thinned && size > 0 && path.size() > size && !Arrays.equals(path.get(size), path.get(size - 1))) {
            path.add(size, CUT);
        }
    }

    /** Adds a state. When the particle is removed, its path ends. */
    @Override
    protected void record(ParticleSystem system, double[] state, double time) {
        int x = Particles.STRIDE * particle.in(system.getParticles());
        int centre = pivot.map(one -> Particles.STRIDE * one.in(system.getParticles())).orElse(x);
        if (x < 0 || centre < 0) {
            return;
        }
        if (pivot.isPresent()) {
            turn(state, x, centre);
        }
        path.add(new double[] {state[x], state[x + 1], state[x + 2], angle, state[x + 3], state[x + 4], state[x + 5],
            rate});
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
        return path.stream().mapToDouble(state -> state[entry]).toArray();
    }

    /**
     * @param axis the component of the motion
     * @param look the look of the path
     * @param name the name of the path, such as its solver's
     * @return the path, cut at jumps
     * @throws IllegalStateException if no run with this particle was observed
     */
    Series path(Coordinate axis, Look look, String name) {
        if (path.isEmpty()) {
            throw new IllegalStateException("no run with a particle '" + id + "' was observed");
        }
        return new Series(look, name, thinned ? Mark.POINTS : Mark.LINE, column(axis.ordinal()),
                column(COORDINATES + axis.ordinal()));
    }

    /**
     * @param axis the component of the motion
     * @param look the look of the path
     * @param name the name of the path, such as its solver's
     * @return the path, and its first and last state once more as marks of their own
     * @throws IllegalStateException if no run with this particle was observed
     */
    public Chart chart(Coordinate axis, Look look, String name) {
        Series line = path(axis, look, name);
        double[] x = line.x();
        double[] v = line.y();
        String whose = " of '" + id + "'" + (axis == Coordinate.ANGLE ? " about '" + about.orElseThrow() + "'" : "");
        Mark mark = path.size() <= FEW ? Mark.LINE_AND_POINTS : line.mark();
        return new Chart(axis.position(whose), axis.velocity(whose), List.of(new Series(look, name, mark, x, v),
                start(x[0], v[0]), Series.point(Look.MARK, "end", Mark.POINTS, x[x.length - 1], v[x.length - 1])));
    }

    /** @return the mark of the start of a path */
    static Series start(double x, double v) {
        return Series.point(Look.MARK.variant(1), "start", Mark.POINTS, x, v);
    }
}
