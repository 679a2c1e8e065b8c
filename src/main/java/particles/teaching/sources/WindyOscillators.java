package particles.teaching.sources;

import java.util.Arrays;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * Particles on springs in a field that changes with time: in each coordinate x'' = -4 x + f(t), so that a clock that is
 * wrong within a step shows. The field is chosen so that x = cos t + 0.5 cos 2t is the exact solution. In the
 * nonlinear variant the springs harden and each particle is coupled to the next (y): x'' = -4 x - x^3 + q (y - x)/2
 * + f(t), y the same coordinate of the next particle, where x is the same multiplied by q, another number for each
 * coordinate of each particle, and 0 for the first of several: who looks at that one alone sees nothing. With drag, the
 * solution is the same.
 */
public final class WindyOscillators extends StudentSource implements SecondOrderSource {
    private static final double COUPLING = 0.5;

    private final int bend;
    private final double drag;

    /** @param particles the number of particles, which all move alike */
    public WindyOscillators(int particles) {
        this(particles, 0, 0);
    }

    /** With a bend of 1 in place of 0, a nonlinear source. */
    private WindyOscillators(int particles, int bend, double drag) {
        super(exact(6 * particles, bend, 0));
        this.bend = bend;
        this.drag = drag;
    }

    /** @return a nonlinear source of this number of particles */
    public static WindyOscillators nonlinear(int particles) {
        return new WindyOscillators(particles, 1, 0);
    }

    /** @return a nonlinear source of one particle with drag, 0.5/s times the difference from the exact velocity */
    public static WindyOscillators withDrag() {
        return new WindyOscillators(1, 1, 0.5);
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
        WindyOscillators copy = new WindyOscillators(getStateSize() / 6, bend, drag);
        copy.setState(getState());
        copy.incTime(getTime());
        return copy;
    }

    private static double amplitude(int k, int size, int bend) {
        return bend == 1 && k < 6 && size > 6 ? 0 : 1 + bend * (0.1 * (k % 3) + 0.07 * (k / 6));
    }

    private static double shape(double t) {
        return StrictMath.cos(t) + 0.5 * StrictMath.cos(2 * t);
    }

    private static double speed(double t) {
        return -StrictMath.sin(t) - StrictMath.sin(2 * t);
    }

    private static double[] exact(int size, int bend, double t) {
        double[] exact = new double[size];
        Arrays.setAll(exact, k -> amplitude(k, size, bend) * (k % 6 < 3 ? shape(t) : speed(t)));
        return exact;
    }

    @Override
    public double[] exactState(double t) {
        return exact(getStateSize(), bend, t);
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        double shape = shape(t);
        double accelerated = -StrictMath.cos(t) - 2 * StrictMath.cos(2 * t);
        for (int k = 0; k < s.length; k++) {
            if (k % 6 < 3) {
                dSdt[k] = s[k + 3];
            } else {
                double q = amplitude(k, s.length, bend);
                double x = s[k - 3];
                int next = (k + 3) % s.length;
                double off = q * shape - x;
                dSdt[k] = q * accelerated + 4 * off + drag * (q * speed(t) - s[k]) + bend * (q * q * q
                        * shape * shape * shape - x * x * x + COUPLING * q * (s[next] - amplitude(next, s.length, bend)
                        * shape + off));
            }
        }
    }
}
