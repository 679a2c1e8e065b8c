package particles.engine;

/** A parallel evaluation of a system's derivative, with the same bits as on one thread. */
public interface ParallelDerivative {
    /** Whether there are enough forces for several threads to be faster. */
    boolean pays();

    /** As {@link ForceSum#derivative}. */
    void derivative(double[] state, double time, double[] dSdt);
}
