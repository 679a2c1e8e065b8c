package particles.teaching.sources;

import java.util.Arrays;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * Particles on springs that harden, each coupled to the next (y), in a field that changes with time, so that a clock
 * that is wrong within a step shows: in each coordinate x'' = -4 x - x^3 + (y - x)/2 + f(t), y the same coordinate of
 * the next particle. The field is chosen so that x = cos t + 0.5 cos 2t is the exact solution, with drag, too. The
 * first particle may stand still at 0, alone: a solver that looks at that one alone sees nothing.
 */
public final class WindyOscillators extends StudentSource implements SecondOrderSource {
    private final int first;
    private final double coupling;
    private final double drag;

    /** @param particles the number of particles, which all move alike */
    public WindyOscillators(int particles) {
        this(particles, 0, 0.5, 0);
    }

    /** With the first entry that moves. */
    private WindyOscillators(int particles, int first, double coupling, double drag) {
        super(exact(6 * particles, first, 0));
        this.first = first;
        this.coupling = coupling;
        this.drag = drag;
    }

    /** @return two particles, of which the first one stands still */
    public static WindyOscillators besideOneAtRest() {
        return new WindyOscillators(2, 6, 0, 0);
    }

    /** @return particles that are not coupled */
    public static WindyOscillators apart(int particles) {
        return new WindyOscillators(particles, 0, 0, 0);
    }

    /** @return one particle with drag, 0.5/s times the difference from the exact velocity */
    public static WindyOscillators withDrag() {
        return new WindyOscillators(1, 0, 0, 0.5);
    }

    /** @return this source, put on the exact solution at this time */
    public WindyOscillators from(double time) {
        startAt(time);
        return this;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return drag != 0;
    }

    /** @return a copy in the same state and time */
    public WindyOscillators copy() {
        WindyOscillators copy = new WindyOscillators(getStateSize() / 6, first, coupling, drag);
        copy.setState(getState());
        copy.incTime(getTime());
        return copy;
    }

    private static double shape(double t) {
        return StrictMath.cos(t) + 0.5 * StrictMath.cos(2 * t);
    }

    private static double speed(double t) {
        return -StrictMath.sin(t) - StrictMath.sin(2 * t);
    }

    private static double[] exact(int size, int first, double t) {
        double[] exact = new double[size];
        Arrays.setAll(exact, k -> k < first ? 0 : k % 6 < 3 ? shape(t) : speed(t));
        return exact;
    }

    @Override
    public double[] exactState(double t) {
        return exact(getStateSize(), first, t);
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        double shape = shape(t);
        double accelerated = -StrictMath.cos(t) - 2 * StrictMath.cos(2 * t);
        for (int k = 0; k < s.length; k++) {
            double x = k % 6 < 3 ? 0 : s[k - 3];
            double y = s[(k + 3) % s.length];
            dSdt[k] = k % 6 < 3 ? s[k + 3] : k < first ? -4 * x : accelerated + 4 * (shape - x) + shape * shape * shape
                    - x * x * x + coupling * (y - x) + drag * (speed(t) - s[k]);
        }
    }
}
