package benchmarks;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/** Tells how long benchmarks take. */
interface Stopwatch {

    /**
     * @param benchmark one of {@link Harness#BENCHMARKS}
     * @param what      the values of its parameter
     * @param begun     hears each before it is measured
     * @return for each the median of all iterations (ns)
     */
    Map<String, Double> medians(Class<?> benchmark, List<String> what, Consumer<String> begun);
}
