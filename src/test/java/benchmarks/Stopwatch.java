package benchmarks;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/** Measures the times of benchmarks. */
interface Stopwatch {

    /**
     * @param benchmark one of {@link Harness#BENCHMARKS}
     * @param what      the values of its parameter
     * @param begun     called before each measurement
     * @return the median of all iterations of each (ns)
     */
    Map<String, Double> medians(Class<?> benchmark, List<String> what, Consumer<String> begun);
}
