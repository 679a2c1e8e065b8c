package particles.teaching.sources;

import java.util.Arrays;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * Particles on springs in a field that changes with time: in each coordinate x'' = -4 x + f(t), so that a clock that is
 * wrong within a step shows. The field is chosen so that x = cos t + 0.5 cos 2t is the exact solution. In the
 * nonlinear variant the springs harden and each particle is coupled to the next (y): x'' = -4 x - x^3 + (y - x)/2
 * + f(t), y the same coordinate of the next particle, where x is the same multiplied by q, another number for each
 * coordinate of each particle. A loose iteration, which solves a linear law in one go, shows there.
 * Two more laws have the same solution: one has drag, and one reads the time off its state, and not off the clock.
 */
public final class WindyOscillators extends StudentSource implements SecondOrderSource {
    private static final double COUPLING = 0.5;
    /** An iteration that gives up does so long before, also one of 10,000 rounds. */
    private static final int MOST_SPOILT = 20_000;

    private final int bend;
    private final int dimension;
    private final double drag;
    /** The number of entries, after the oscillators', of a particle that flies at 1 m/s and so tells the time. */
    private final int timer;
    private int failFrom = Integer.MAX_VALUE;
    private boolean failed;
    private boolean spoilt;

    /** @param particles the number of particles; six numbers each */
    public WindyOscillators(int particles) {
        this(particles, 0, 3, 0, 0);
    }

    /** With 1 in place of 0, a nonlinear source. */
    private WindyOscillators(int particles, int bend, int dimension, double drag, int timer) {
        super(exact(2 * dimension * particles, bend, dimension, timer, 0));
        this.bend = bend;
        this.dimension = dimension;
        this.drag = drag;
        this.timer = timer;
    }

    /** @return a nonlinear source of this number of particles */
    public static WindyOscillators nonlinear(int particles) {
        return new WindyOscillators(particles, 1, 3, 0, 0);
    }

    /** @return a nonlinear source of one particle with drag, 0.5/s times the difference from the exact velocity */
    public static WindyOscillators withDrag() {
        return new WindyOscillators(1, 1, 3, 0.5, 0);
    }

    /** @return a nonlinear source of one particle whose law depends on its state alone, which tells the time, too */
    public static WindyOscillators timeless() {
        return new WindyOscillators(1, 1, 3, 0, 6);
    }

    /** @return a source of this number of particles on a line; two numbers each */
    public static WindyOscillators onLine(int particles) {
        return new WindyOscillators(particles, 0, 1, 0, 0);
    }

    /** @return this source, put on the exact solution at this time */
    public WindyOscillators from(double time) {
        startAt(time);
        return this;
    }

    @Override
    public int getDimension() {
        return dimension;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return drag != 0;
    }

    /** @return a copy in the same state and time */
    public WindyOscillators copy() {
        WindyOscillators copy = new WindyOscillators((getStateSize() - timer) / 2 / dimension, bend, dimension,
                drag, timer);
        copy.setState(getState());
        copy.incTime(getTime());
        return copy;
    }

    private static double amplitude(int k, int bend) {
        return 1 + bend * (0.1 * (k % 3) + 0.07 * (k / 6));
    }

    private static double shape(double t) {
        return StrictMath.cos(t) + 0.5 * StrictMath.cos(2 * t);
    }

    private static double speed(double t) {
        return -StrictMath.sin(t) - StrictMath.sin(2 * t);
    }

    private static double[] exact(int size, int bend, int dimension, int timer, double t) {
        double[] exact = new double[size + timer];
        Arrays.setAll(exact, k -> k >= size ? (k - size < dimension ? t : 1) : amplitude(k, bend)
                * (k / dimension % 2 == 0 ? shape(t) : speed(t)));
        return exact;
    }

    @Override
    public double[] exactState(double t) {
        return exact(getStateSize() - timer, bend, dimension, timer, t);
    }

    /** @param evaluation the number of the first evaluation, from 0, that is to fail */
    public void failFromEvaluation(int evaluation) {
        failFrom = evaluation;
    }

    /** @return whether an evaluation failed */
    public boolean hasFailed() {
        return failed;
    }

    /** Makes the derivative NaN from now on. */
    public void spoilDerivative() {
        spoilt = true;
        endAfter(MOST_SPOILT);
    }

    @Override
    protected void rates(double clock, double[] s, double[] dSdt) {
        if (getEvaluations() - 1 >= failFrom) {
            failed = true;
            throw new IllegalStateException("the source fails, as it was told to");
        }
        int size = s.length - timer;
        double t = timer > 0 ? s[size] : clock;
        double shape = shape(t);
        double accelerated = -StrictMath.cos(t) - 2 * StrictMath.cos(2 * t);
        for (int k = 0; k < Math.min(s.length, dSdt.length); k++) {
            if (k / dimension % 2 == 0) {
                dSdt[k] = s[k + dimension];
            } else if (k >= size) {
                dSdt[k] = 0;
            } else {
                double q = amplitude(k, bend);
                double x = s[k - dimension];
                int next = (k + dimension) % size;
                double off = q * shape - x;
                dSdt[k] = q * accelerated + 4 * off + drag * (q * speed(t) - s[k]) + bend * (q * q * q
                        * shape * shape * shape - x * x * x + COUPLING * (s[next] - amplitude(next, bend) * shape
                        + off));
            }
            dSdt[k] = spoilt ? Double.NaN : dSdt[k];
        }
    }
}
