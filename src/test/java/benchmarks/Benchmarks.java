package benchmarks;

import hunts.TaskOptions;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.results.format.ResultFormatType;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import particles.output.FrameBenchmark;

/** {@code gradle benchmark}: runs the benchmarks with JMH, which prints its progress and a table at the end. */
public final class Benchmarks {
    private static final List<Class<?>> CLASSES = List.of(StepBenchmark.class, ErrorBenchmark.class,
            SceneBenchmark.class, FrameBenchmark.class);
    /** These are measured only when they are asked for. */
    private static final List<String> LARGE = List.of("cloth-64", "cloth-256");
    private static final List<String> PARAMETERS = List.of("workload", "method", "integrator", "scene");
    private static final String CHECK = "check";
    private static final List<String> OPTIONS = List.of(CHECK, "include", "workload", "method", "integrator", "scene", 
            "forks", "iterations", "milliseconds");
    private static final Path RESULTS = Path.of("build", "out", "benchmark", "benchmark.csv");

    private Benchmarks() {
    }

    /**
     * @param args {@code --name=value}: a regular expression that selects classes, parameters of the benchmarks
     *             separated by commas, and JMH's settings
     * @throws IllegalArgumentException if an option is not valid
     */
    static ChainedOptionsBuilder options(String... args) {
        TaskOptions given = new TaskOptions(args, OPTIONS);
        int iterations = (int) given.getCount("iterations", 5);
        TimeValue time = TimeValue.milliseconds(given.getCount("milliseconds", 60));
        // Compilation in the foreground: few iterations are enough for warm-up.
        ChainedOptionsBuilder options = new OptionsBuilder().include(given.get("include", "."))
                .forks((int) given.getCount("forks", 1)).jvmArgsAppend("-Xbatch").shouldFailOnError(true)
                .warmupIterations(iterations).warmupTime(time).measurementIterations(iterations).measurementTime(time)
                .resultFormat(ResultFormatType.CSV).result(RESULTS.toString());
        for (String parameter : PARAMETERS) {
            String values = given.get(parameter, "");
            if (!values.isEmpty()) {
                options.param(parameter, allowed(parameter, values.split(",")));
            }
        }
        return options;
    }

    private static String[] allowed(String parameter, String... values) {
        Set<String> known = new TreeSet<>(parameter.equals("workload") ? LARGE : List.of());
        CLASSES.stream().flatMap(type -> Arrays.stream(type.getFields()))
                .filter(field -> field.getName().equals(parameter))
                .forEach(field -> known.addAll(List.of(field.getAnnotation(Param.class).value())));
        for (String value : values) {
            if (!known.contains(value)) {
                throw new IllegalArgumentException("option -P" + parameter + ": '" + value + "' is not one of: "
                        + String.join(", ", known));
            }
        }
        return values;
    }

    /** @param args as for {@link #options}; {@code --check=true} runs the {@link RatioCheck} instead */
    public static void main(String[] args) throws Exception {
        System.setProperty("jmh.ignoreLock", "true");           // another user's lock would block for ever
        try {
            if (new TaskOptions(args, OPTIONS).get(CHECK, "false").equals("true")) {
                System.exit(RatioCheck.run(System.out) ? 0 : 1);
            }
            Files.createDirectories(RESULTS.getParent());
            new Runner(options(args).build()).run();
        } catch (IllegalArgumentException | RunnerException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }
}
