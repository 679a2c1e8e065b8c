package particles.experiments.phase;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.view.VectorField;

/** The arrows of the slide "Vectors show the vector field", for systems that have one degree of freedom. */
public final class VectorFields {
    /** Arrows along the position and along the velocity. */
    private static final int COLUMNS = 19;
    private static final int ROWS = 15;
    /** A margin around the path, as a part of its extent. */
    private static final double MARGIN = 0.15;
    /** Forces and speeds across the axis that are below this part of those along it are rounding. */
    private static final double ROUNDING = 1e-9;

    private VectorFields() {
    }

    /**
     * Evaluates the field on a grid around a path. A system has one degree of freedom for this purpose if one particle
     * can move, and no force on the grid drives it across the axis. Only effects are evaluated, not reactions.
     *
     * @param system the system at its present time; not changed, and no evaluations are counted
     * @param axis   the axis along which the particle moves
     * @param x      the positions of the path (m); NaN where it is cut
     * @param v      its velocities (m/s)
     * @return the field; empty for an angle, if there are more degrees of freedom or moving anchors, or if the path has
     *         no extent
     */
    public static Optional<VectorField> around(ParticleSystem system, Coordinate axis, double[] x, double[] v) {
        if (axis == Coordinate.ANGLE) {
            return Optional.empty();
        }
        Particles particles = system.getParticles();
        int[] free = particles.free().toArray();
        double[] xs = grid(x, COLUMNS);
        double[] vs = grid(v, ROWS);
        if (free.length != 1 || system.getMovingAnchors().length > 0 || xs.length == 0 || vs.length == 0) {
            return Optional.empty();
        }
        double[] state = Arrays.copyOf(system.getOwnState(), system.getStateSize());
        double[] force = new double[state.length];
        int first = Particles.STRIDE * free[0];
        int along = first + axis.ordinal();
        double speedAcross = across(state, first + 3, axis);
        VectorField field = new VectorField(xs, vs);
        double largest = 0;
        double largestAcross = 0;
        for (int k = 0; k < field.dv().length; k++) {
            state[along] = field.x(k);
            state[along + 3] = field.v(k);
            system.addUpEffects(state, system.getTime(), force);
            field.dv()[k] = force[along + 3] * particles.getInverseMasses()[free[0]];
            largest = Math.max(largest, Math.abs(force[along + 3]));
            largestAcross = Math.max(largestAcross, across(force, first + 3, axis));
        }
        double fastest = Math.max(Math.abs(vs[0]), Math.abs(vs[vs.length - 1]));
        boolean one = largestAcross <= ROUNDING * largest && speedAcross <= ROUNDING * fastest;
        return one ? Optional.of(field) : Optional.empty();
    }

    private static double across(double[] values, int first, Coordinate axis) {
        return IntStream.range(0, 3).filter(c -> c != axis.ordinal()).mapToDouble(c -> Math.abs(values[first + c]))
                .max().orElse(0);
    }

    private static double[] grid(double[] values, int count) {
        DoubleSummaryStatistics range = PhaseHistory.range(values);
        double low = range.getMin();
        double extent = range.getMax() - low;
        return extent > 0 && Double.isFinite(extent) ? IntStream.range(0, count).mapToDouble(k ->
                low - MARGIN * extent + (1 + 2 * MARGIN) * extent * k / (count - 1)).toArray() : new double[0];
    }
}
