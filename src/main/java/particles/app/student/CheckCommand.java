package particles.app.student;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.ProgramCommand;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;
import particles.output.report.ResultPageWriter;
import particles.output.text.TableText;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import picocli.CommandLine.Option;

/**
 * A command that checks a student's class: the check runs in a process of its own, with a limit to its computing time.
 */
abstract class CheckCommand extends ProgramCommand {
    private static final double SECONDS = 8;

    @Option(names = "--out", paramLabel = "FOLDER",
            description = "Where the report goes (default: build/out and the task's name).")
    private String out;

    @Option(names = "--inThisProcess", hidden = true, description = "Checks here, as the process that was made for it.")
    private boolean inThisProcess;

    /** What a check makes known. */
    record Checked(String title, List<Finding> findings, ResultPage page) {
    }

    /** @return the command's name, which is its task's */
    abstract String name();

    /** @return the option that says what is checked, and its value */
    abstract String subject();

    /** @throws Failure if there is nothing of that name; runs the class's own code */
    abstract Checked check();

    @Override
    public final void run(PrintWriter lines) throws Exception {
        if (inThisProcess) {
            checkHere(lines);
            return;
        }
        List<String> args = new ArrayList<>(List.of(name(), subject(), "--inThisProcess"));
        if (out != null) {                              // picocli leaves an option null that was not given
            args.add("--out=" + out);
        }
        int code;
        try {
            code = StudentProcess.run(args);
        } catch (Failure stopped) {
            writeReport(failed(stopped.getMessage()));
            throw stopped;
        }
        if (code != ExitCode.DONE.code()) {
            throw new Failure(code == ExitCode.TROUBLE.code() ? ExitCode.TROUBLE : ExitCode.BAD_INPUT, List.of());
        }
    }

    private void checkHere(PrintWriter lines) {
        GuardedRun guard = new GuardedRun(SECONDS);
        Thread hook = new Thread(() -> guard.runningAt().ifPresent(place -> {
            giveUp(lines, new Finding(Kind.FAILURE, "the class ends the whole program (System.exit)" + place));
        }));
        Runtime.getRuntime().addShutdownHook(hook);
        PrintStream screen = System.out;
        Printed printed = new Printed();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        Outcome<Checked> outcome;
        try {
            outcome = guard.run(this::check);
        } finally {
            System.setOut(screen);
        }
        if (!printed.text().isEmpty()) {
            lines.println("the class printed:" + System.lineSeparator() + printed.text());
        }
        if (outcome.failure().isPresent()) {
            giveUp(lines, outcome.failure().get());
        }
        report(lines, outcome.value().orElseThrow());
    }

    /**
     * Writes the report of a check that did not come back, and ends the process: the class's thread may still be
     * running.
     */
    private void giveUp(PrintWriter lines, Finding failure) {
        ExitCode code = ExitCode.BAD_INPUT;
        lines.println(failure);
        try {
            lines.println("report: " + writeReport(failed(failure.text())));
        } catch (OutputException e) {
            lines.println(e.getMessage());
            code = ExitCode.TROUBLE;
        }
        lines.flush();
        Runtime.getRuntime().halt(code.code());
    }

    private ResultPage failed(String reason) {
        String title = subject().replaceFirst(".*=", "") + ": the check did not come to its end.";
        return new ResultPage(name(), title, paragraphs(List.of(new Finding(Kind.FAILURE, reason))), List.of(),
                List.of());
    }

    /** @return where the report is */
    private Path writeReport(ResultPage page) {
        Path folder = out == null ? Path.of("build", "out", name()) : Path.of(out);
        try (OutputFolder files = OutputFolder.open(folder, name() + ".md")) {
            ResultPageWriter.write(files, page);
        }
        return folder.resolve(name() + ".md");
    }

    private void report(PrintWriter lines, Checked checked) {
        Path report = writeReport(checked.page());
        lines.println(checked.title());
        List<Finding> wrong = checked.findings().stream().filter(Finding::isWrong).toList();
        lines.println();
        lines.println(wrong.isEmpty() ? "Nothing is wrong." : "Wrong:");
        wrong.forEach(finding -> lines.println("  " + finding));
        List<Finding> advice = checked.findings().stream().filter(finding -> !finding.isWrong()).toList();
        if (!advice.isEmpty()) {
            lines.println("Advice:");
            advice.forEach(finding -> lines.println("  " + finding.text()));
        }
        if (!checked.page().tables().isEmpty()) {
            lines.println();
            TableText.plain(checked.page().tables().get(0)).forEach(lines::println);
        }
        lines.println();
        lines.println("report: " + report);
        if (!wrong.isEmpty()) {
            throw new Failure(ExitCode.BAD_INPUT, wrong.size() == 1 ? "one thing is wrong"
                    : wrong.size() + " things are wrong");
        }
    }

    /** @return the findings as paragraphs of a report */
    static List<String> paragraphs(List<Finding> findings) {
        List<String> text = new ArrayList<>();
        text.add(findings.stream().anyMatch(Finding::isWrong) ? "What is wrong:" : "Nothing is wrong.");
        findings.stream().filter(Finding::isWrong).forEach(finding -> text.add("- **" + finding.kind().word() + "**: "
                + finding.text()));
        if (findings.stream().anyMatch(finding -> !finding.isWrong())) {
            text.add("Advice:");
            findings.stream().filter(finding -> !finding.isWrong()).forEach(finding -> text.add("- " + finding.text()));
        }
        return text;
    }

    /** Keeps the beginning of what a class prints, and no more. */
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
