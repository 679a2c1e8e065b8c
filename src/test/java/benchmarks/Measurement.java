package benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * JMH's settings: forks, iterations and their length.
 *
 * @param forks      the number of processes, run one after another; 0 for this one
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
    public double median(Class<?> benchmark, String what) {
        TimeValue time = TimeValue.nanoseconds((long) (seconds * TimeUnit.SECONDS.toNanos(1)));
        System.setProperty("jmh.ignoreLock", "true");           // another user's lock would block for ever
        String log = "build/jmh/log.txt";
        Options options = new OptionsBuilder().include("^" + benchmark.getName().replace(".", "\\.") + "\\.")
                .param("what", what).forks(forks).shouldFailOnError(true).jvmArgsAppend(JVM).output(log)
                .warmupIterations(iterations).warmupTime(time).measurementIterations(iterations).measurementTime(time)
                .build();
        try {
            return new Runner(options).runSingle().getPrimaryResult().getStatistics().getPercentile(50);
        } catch (RunnerException e) {
            throw new IllegalStateException("JMH failed at '" + what + "': " + e.getMessage() + "; see " + log, e);
        }
    }
}
