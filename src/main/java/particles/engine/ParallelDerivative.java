package particles.engine;

/** Another way to evaluate a system's derivative, with the same bits; handed to the system from outside. */
public interface ParallelDerivative extends AutoCloseable {
    /** Whether there is enough to do for it to be worth while. */
    boolean pays();

    /** As {@link ForceSum#derivative}. */
    void derivative(double[] state, double time, double[] dSdt);

    @Override
    void close();
}
