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
 * How long and how often JMH measures.
 *
 * @param forks      how many processes one after the other, each with a compiler that begins anew
 * @param iterations in each of them, after as many that do not count
 * @param seconds    that each lasts
 */
public record Measurement(int forks, int iterations, double seconds) implements Stopwatch {
    /**
     * The collector that scripts start the program with; and the compiler at once, so that few iterations warm it up.
     */
    private static final String[] JVM = {"-XX:+UseSerialGC", "-Xbatch"};

    @Override
    public Map<String, Double> medians(Class<?> benchmark, List<String> what, Consumer<String> begun) {
        TimeValue time = TimeValue.nanoseconds((long) (seconds * TimeUnit.SECONDS.toNanos(1)));
        System.setProperty("jmh.ignoreLock", "true");           // another user's lock would stop us for ever
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
