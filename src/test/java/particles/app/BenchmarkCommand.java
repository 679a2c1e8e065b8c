package particles.app;

import benchmarks.BenchmarkTables;
import benchmarks.Benchmarks;
import benchmarks.Measurement;
import java.io.PrintWriter;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import particles.app.cli.Mistakes;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.experiments.ExperimentCommand;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;
import particles.view.DataTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle benchmark}: a separate program, since it needs test classes. */
@Command(name = BenchmarkCommand.NAME, description = "Measures the speed of solvers, scenes and frames.")
final class BenchmarkCommand extends ExperimentCommand {
    static final String NAME = "benchmark";

    @Option(names = "--include", paramLabel = "REGEX", defaultValue = "",
            description =
                    "Only what this regular expression is found in, such as 'chain rk4' or '^scene' (default: all).")
    private String include;

    @Option(names = "--forks", paramLabel = "NUMBER", defaultValue = "1",
            description = "In how many processes each is measured, one after the other (default: ${DEFAULT-VALUE}).")
    private int forks;

    @Option(names = "--iterations", paramLabel = "NUMBER", defaultValue = "5",
            description =
                    "How often in each of them, after as many times that do not count (default: ${DEFAULT-VALUE}).")
    private int iterations;

    @Option(names = "--seconds", paramLabel = "SECONDS", defaultValue = "0.06",
            description = "How long each time (default: ${DEFAULT-VALUE}).")
    private double seconds;

    @Override
    protected void read(Mistakes mistakes) {
        mistakes.check(() -> requireWithin("forks", forks, 1, Integer.MAX_VALUE));
        mistakes.check(() -> requireWithin("iterations", iterations, 1, Integer.MAX_VALUE));
        mistakes.check(() -> positive("seconds", seconds));
        mistakes.check(this::checkNames);
        super.read(mistakes);
    }

    private void checkNames() {
        if (Benchmarks.names().stream().noneMatch(included())) {
            throw wrong("include", "'" + include + "' is found in none of: " + String.join(", ", Benchmarks.names()));
        }
    }

    private Predicate<String> included() {
        try {
            return Pattern.compile(include).asPredicate();
        } catch (PatternSyntaxException e) {
            throw wrong("include", "'" + include + "' is no regular expression: " + e.getDescription());
        }
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        List<DataTable> tables = new Benchmarks(included(), new Measurement(forks, iterations, seconds),
                progress).measure();
        return new ResultPage(NAME, BenchmarkTables.finding(tables),
                List.of("Medians of " + forks + " x " + iterations + " iterations of " + seconds + " s by JMH, Java "
                        + Runtime.version().feature() + """
                        , one thread; steps and their loops by hand in one process. At equal evaluations both make the \
                        same steps of the same method; at equal error each has the coarsest setting that ends within \
                        1e-6 of a reference solution, over the largest entry of the state."""), List.of(), tables);
    }

    /** @param args options, as for any command of the program */
    public static void main(String[] args) {
        String[] all = new String[args.length + 1];
        all[0] = NAME;
        System.arraycopy(args, 0, all, 1, args.length);
        System.exit(new Program(List.of(new BenchmarkCommand()), OptionStyle.current(),
                new PrintWriter(System.out, true), new PrintWriter(System.err, true)).execute(all).code());
    }
}
