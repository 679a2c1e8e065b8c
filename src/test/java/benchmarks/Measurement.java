package benchmarks;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * JMH's settings: forks, iterations and their length.
 *
 * @param forks      the number of processes, run one after another
 * @param iterations measured iterations in each, after as many for warm-up
 * @param seconds    the length of an iteration (s)
 */
public record Measurement(int forks, int iterations, double seconds) implements Stopwatch {
    /**
     * The garbage collector of the start scripts, and compilation in the foreground, so that few iterations are enough
     * for warm-up.
     */
    private static final String[] JVM = {"-XX:+UseSerialGC", "-Xbatch"};

    @Override
    public Map<String, Double> medians(Class<?> benchmark, List<String> what, Consumer<String> begun) {
        TimeValue time = TimeValue.nanoseconds((long) (seconds * TimeUnit.SECONDS.toNanos(1)));
        System.setProperty("jmh.ignoreLock", "true");           // another user's lock would block for ever
        Options options = new OptionsBuilder().include("^" + benchmark.getName().replace(".", "\\.") + "\\.")
                .param("what", what.toArray(String[]::new)).forks(forks).shouldFailOnError(true).jvmArgsAppend(JVM)
                .warmupIterations(iterations).warmupTime(time).measurementIterations(iterations).measurementTime(time)
                .build();
        Map<String, Double> medians = new LinkedHashMap<>();
        Heard heard = new Heard(begun);
        try {
            for (RunResult result : new Runner(options, heard).run()) {
                medians.put(result.getParams().getParam("what"),
                        result.getPrimaryResult().getStatistics().getPercentile(50));
            }
        } catch (RunnerException e) {
            throw new IllegalStateException("JMH failed: " + e.getMessage() + "\n" + heard.lines(), e);
        }
        return medians;
    }
}
