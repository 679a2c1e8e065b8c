package benchmarks;

/** Measures the times of benchmarks. */
interface Stopwatch {

    /**
     * @param benchmark one of {@link Harness#BENCHMARKS}
     * @param what      the value of its parameter
     * @return the median of all iterations (ns)
     */
    double median(Class<?> benchmark, String what);
}
