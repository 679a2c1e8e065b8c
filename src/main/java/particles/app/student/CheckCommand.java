package particles.app.student;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.ResultsCommand;
import particles.app.student.StudentProcess.Task;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.output.report.ResultPageWriter;
import particles.spec.messages.InvalidInputException;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import particles.view.DataTable;
import picocli.CommandLine.Option;

/**
 * A command that checks a student's class. The check runs in a process of its own, with a limit on its CPU time.
 */
abstract class CheckCommand extends ResultsCommand {
    private static final double SECONDS = 7;

    @Option(names = "--inThisProcess", hidden = true, description = "Checks here, as the process that was made for it.")
    private boolean inThisProcess;

    @Option(names = StudentProcess.VERDICT, hidden = true,
            description = "Checks the sources that it reads from its input; writes a signed verdict into this file.")
    private Path verdict;

    /**
     * The result of a check.
     *
     * @param subject  the short name of the class checked
     * @param identity the method or law identified, in a sentence
     * @param findings mistakes and notes
     * @param pictures the pictures of the report
     * @param tables   its tables
     */
    record Checked(String subject, String identity, List<Finding> findings, List<Picture> pictures,
            List<DataTable> tables) {
        /** In place of the identity. */
        static final String NOT_CHECKED = "it cannot be checked.";

        /** A result without pictures and tables. */
        Checked(String subject, String identity, List<Finding> findings) {
            this(subject, identity, findings, List.of(), List.of());
        }

        /** A class that cannot be checked, for this reason. */
        Checked(String subject, Exception reason) {
            this(subject, NOT_CHECKED, List.of(new Finding(Kind.FAILURE, String.valueOf(reason.getMessage()))));
        }

        boolean isRight() {
            return findings.stream().noneMatch(Finding::isWrong);
        }

        /** @return the findings as paragraphs of a report */
        private List<String> paragraphs() {
            List<String> text = new ArrayList<>(List.of(isRight() ? "Nothing is wrong." : "What is wrong:"));
            findings.stream().filter(Finding::isWrong).forEach(finding -> text.add("- **" + finding.kind().word()
                    + "**: " + finding.text()));
            List<String> advice = findings.stream().filter(finding -> !finding.isWrong()).map(finding -> "- "
                    + finding.text()).toList();
            if (!advice.isEmpty()) {
                text.add("Advice:");
                text.addAll(advice);
            }
            return text;
        }
    }

    /** @return the option that names the class to check, and its value */
    abstract String subject();

    /** @return options for the check's process; none if no charts are drawn */
    List<String> chartArguments() {
        return List.of();
    }

    /** @return the format of its charts */
    ChartFormat format() {
        return ChartFormat.PAGE;
    }

    /** @throws InvalidInputException if no such class exists; runs the class's own code */
    abstract Checked check();

    @Override
    public final void run(PrintWriter lines) throws Exception {
        if (verdict != null) {                          // picocli leaves an option null that was not given
            Task task;
            try (ObjectInputStream input = new ObjectInputStream(System.in)) {
                task = (Task) input.readObject();
            }
            new StudentLoader(task::sources, CheckCommand.class.getClassLoader()).install();
            checkHere((code, report) -> end(task, code, report));
            return;
        }
        if (inThisProcess) {
            checkHere((code, report) -> report.forEach(lines::println));
            return;
        }
        List<String> args = new ArrayList<>(List.of(name(), subject(), "--out=" + getFolder()));
        args.addAll(chartArguments());
        Files.deleteIfExists(report());
        StudentProcess.Outcome outcome = StudentProcess.run(args, StudentLoader.installed());
        if (!Files.exists(report())) {                  // its process was ended before it wrote one
            writeReport(unfinished(new Finding(outcome.code() == ExitCode.STOPPED ? Kind.UNDECIDED : Kind.FAILURE,
                    String.join(" ", outcome.lines()).replaceFirst("^(wrong|not decided): ", ""))));
        }
        outcome.lines().forEach(lines::println);
        if (outcome.code() != ExitCode.DONE) {
            throw new Failure(outcome.code(), "");
        }
    }

    /** Where the verdict and the check's own lines go. */
    private interface Screen {
        void show(ExitCode code, List<String> lines);
    }

    /** Writes the verdict once and ends the process, in which code of the class may still be running. */
    private synchronized void end(Task task, ExitCode code, List<String> report) {
        try {
            Files.write(verdict, task.sign(new StudentProcess.Outcome(code, report.stream().flatMap(String::lines)
                    .toList())));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            Runtime.getRuntime().halt(code.code());
        }
    }

    private void checkHere(Screen screen) {
        GuardedRun guard = new GuardedRun(SECONDS);
        Thread hook = new Thread(() -> guard.runningAt().ifPresent(place -> giveUp(screen, new Finding(Kind.FAILURE,
                "the class ends the whole program (System.exit)" + place), "")));
        Runtime.getRuntime().addShutdownHook(hook);
        PrintStream before = System.out;
        Printed printed = new Printed();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        Outcome<Checked> outcome;
        try {
            outcome = guard.run(this::check);
        } finally {
            System.setOut(before);
        }
        outcome.failure().ifPresent(failure -> giveUp(screen, failure, printed.text()));
        ExitCode code = show(screen, outcome.value().orElseThrow(), printed.text());
        if (code != ExitCode.DONE) {
            throw new Failure(code, "");
        }
    }

    /** Reports a check that did not finish, and ends the process, in which the class's thread may still be running. */
    private void giveUp(Screen screen, Finding failure, String printed) {
        Runtime.getRuntime().halt(show(screen, unfinished(failure), printed).code());
    }

    /** Writes the report and shows the verdict. */
    private ExitCode show(Screen screen, Checked checked, String printed) {
        ExitCode code = checked.isRight() ? ExitCode.DONE : checked.findings().stream().allMatch(finding ->
                !finding.isWrong() || finding.kind() == Kind.UNDECIDED) ? ExitCode.STOPPED : ExitCode.BAD_INPUT;
        List<String> lines;
        try {
            lines = CheckReport.lines(checked, printed, writeReport(checked));
        } catch (OutputException e) {
            lines = List.of(e.getMessage());
            code = ExitCode.TROUBLE;
        }
        screen.show(code, lines);
        return code;
    }

    private Checked unfinished(Finding failure) {
        return new Checked(subject().replaceFirst(".*=", ""), "The check did not finish.", List.of(failure));
    }

    private Path report() {
        return getFolder().resolve(name() + ".md");
    }

    /** @return the report's file */
    private Path writeReport(Checked checked) {
        try (OutputFolder files = OutputFolder.open(getFolder(), name() + ".md")) {
            ResultPageWriter.write(files, new ResultPage(name(), checked.subject() + ": " + checked.identity(),
                    checked.paragraphs(), checked.pictures(), checked.tables()), format());
        }
        return report();
    }

    /** Keeps only the beginning of a class's output. */
    private static final class Printed extends OutputStream {
        private static final int MOST = 2000;
        private final ByteArrayOutputStream kept = new ByteArrayOutputStream();

        @Override
        public synchronized void write(int b) {
            if (kept.size() < MOST) {
                kept.write(b);
            }
        }

        synchronized String text() {
            return kept.toString(StandardCharsets.UTF_8);
        }
    }
}
