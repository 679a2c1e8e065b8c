package particles.experiments.phase;

import java.util.Arrays;
import java.util.Optional;
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
     * @param x      the positions of the path (m)
     * @param v      its velocities (m/s)
     * @return the field; empty for an angle, if there are more degrees of freedom, or if the path has no extent
     */
    public static Optional<VectorField> around(ParticleSystem system, Axis axis, double[] x, double[] v) {
        if (axis == Axis.ANGLE) {
            return Optional.empty();
        }
        Particles particles = system.getParticles();
        int free = -1;
        for (int i = 0; i < particles.count(); i++) {
            if (!particles.isFixed(i)) {
                if (free >= 0) {
                    return Optional.empty();
                }
                free = i;
            }
        }
        double[] xs = grid(x, COLUMNS);
        double[] vs = grid(v, ROWS);
        if (free < 0 || xs.length == 0 || vs.length == 0) {
            return Optional.empty();
        }
        double[] state = new double[system.getStateSize()];
        System.arraycopy(system.getOwnState(), 0, state, 0, state.length);
        double[] force = new double[state.length];
        int first = Particles.STRIDE * free;
        int along = first + axis.ordinal();
        double speedAcross = across(state, first + 3, axis);
        VectorField field = new VectorField(new double[xs.length * vs.length], new double[xs.length * vs.length],
                new double[xs.length * vs.length], new double[xs.length * vs.length]);
        double largest = 0;
        double largestAcross = 0;
        for (int k = 0; k < field.x().length; k++) {
            state[along] = field.x()[k] = xs[k % xs.length];
            state[along + 3] = field.v()[k] = field.dx()[k] = vs[k / xs.length];
            system.addUpEffects(state, system.getTime(), force);
            field.dv()[k] = force[along + 3] * particles.getInverseMasses()[free];
            largest = Math.max(largest, Math.abs(force[along + 3]));
            largestAcross = Math.max(largestAcross, across(force, first + 3, axis));
        }
        double fastest = Math.max(Math.abs(vs[0]), Math.abs(vs[vs.length - 1]));
        boolean one = largestAcross <= ROUNDING * largest && speedAcross <= ROUNDING * fastest;
        return one ? Optional.of(field) : Optional.empty();
    }

    private static double across(double[] values, int first, Axis axis) {
        double largest = 0;
        for (int c = 0; c < 3; c++) {
            if (c != axis.ordinal()) {
                largest = Math.max(largest, Math.abs(values[first + c]));
            }
        }
        return largest;
    }

    private static double[] grid(double[] values, int count) {
        double low = Arrays.stream(values).min().orElse(0);
        double high = Arrays.stream(values).max().orElse(0);
        double extent = high - low;
        if (!(extent > 0) || !Double.isFinite(extent)) {
            return new double[0];
        }
        double[] grid = new double[count];
        for (int k = 0; k < count; k++) {
            grid[k] = low - MARGIN * extent + (1 + 2 * MARGIN) * extent * k / (count - 1);
        }
        return grid;
    }
}
