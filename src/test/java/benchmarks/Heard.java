package benchmarks;

import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.function.Consumer;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.infra.IterationParams;
import org.openjdk.jmh.results.BenchmarkResult;
import org.openjdk.jmh.results.IterationResult;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.format.OutputFormat;

/** Listens to JMH's output: which benchmark is running, and the text of a failure. */
final class Heard implements OutputFormat {
    private final Consumer<String> begun;
    private final StringBuilder lines = new StringBuilder();

    Heard(Consumer<String> begun) {
        this.begun = begun;
    }

    @Override
    public void startBenchmark(BenchmarkParams params) {
        lines.setLength(0);
        begun.accept(params.getParam("what"));
    }

    /** JMH's output since the last benchmark began, for error messages. */
    String lines() {
        return lines.toString();
    }

    @Override
    public void print(String text) {
        lines.append(text);
    }

    @Override
    public void println(String text) {
        lines.append(text).append('\n');
    }

    @Override
    public void write(int character) {
        lines.append((char) character);
    }

    @Override
    public void write(byte[] text) {
        lines.append(new String(text, StandardCharsets.UTF_8));
    }

    @Override
    public void iteration(BenchmarkParams params, IterationParams iteration, int number) {
        // not heard
    }

    @Override
    public void iterationResult(BenchmarkParams params, IterationParams iteration, int number, IterationResult result) {
        // not heard
    }

    @Override
    public void endBenchmark(BenchmarkResult result) {
        // not heard
    }

    @Override
    public void startRun() {
        // not heard
    }

    @Override
    public void endRun(Collection<RunResult> results) {
        // not heard
    }

    @Override
    public void verbosePrintln(String text) {
        // not heard
    }

    @Override
    public void flush() {
        // nothing is held back
    }

    @Override
    public void close() {
        // nothing is open
    }
}
