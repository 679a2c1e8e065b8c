package particles.app.student;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import particles.app.cli.ExitCode;
import particles.app.student.Check.Checked;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;

/**
 * Makes a check with a limit on its CPU time, and writes its report.
 *
 * @param check  the check
 * @param folder receives the report
 * @param screen shows the verdict
 */
record CheckRun(Check check, Path folder, Screen screen) {
    private static final double SECONDS = 7;

    /** Where the verdict and the check's own lines go. */
    interface Screen {
        void show(ExitCode code, List<String> lines);
    }

    /** @return the verdict */
    ExitCode run() {
        GuardedRun guard = new GuardedRun(SECONDS);
        Thread hook = new Thread(() -> guard.runningAt().ifPresent(place -> giveUp(new Finding(Kind.FAILURE,
                "the class ends the whole program (System.exit)" + place), "")));
        Runtime.getRuntime().addShutdownHook(hook);
        PrintStream before = System.out;
        Printed printed = new Printed();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        Outcome<Checked> outcome;
        try {
            outcome = guard.run(check::make);
        } finally {
            System.setOut(before);
        }
        outcome.failure().ifPresent(failure -> giveUp(failure, printed.text()));
        return show(outcome.value().orElseThrow(), printed.text());
    }

    /** Reports a check that did not finish, and ends the process, in which the class's thread may still be running. */
    private void giveUp(Finding failure, String printed) {
        Runtime.getRuntime().halt(show(unfinished(check, failure), printed).code());
    }

    /** Writes the report and shows the verdict. */
    private ExitCode show(Checked checked, String printed) {
        ExitCode code = checked.isRight() ? ExitCode.DONE : checked.findings().stream().allMatch(finding ->
                !finding.isWrong() || finding.kind() == Kind.UNDECIDED) ? ExitCode.STOPPED : ExitCode.BAD_INPUT;
        List<String> lines;
        try {
            lines = CheckReport.lines(checked, printed, write(check, checked, folder));
        } catch (OutputException e) {
            lines = List.of(e.getMessage());
            code = ExitCode.TROUBLE;
        }
        screen.show(code, lines);
        return code;
    }

    /** Reports a check whose process was ended before it wrote a report. */
    static void writeUnfinished(Check check, Path folder, Finding failure) {
        write(check, unfinished(check, failure), folder);
    }

    private static Checked unfinished(Check check, Finding failure) {
        return new Checked(check.subject(), "The check did not finish.", List.of(failure));
    }

    /** @return the report's file */
    private static Path write(Check check, Checked checked, Path folder) {
        Path report = check.report(folder);
        try (OutputFolder files = OutputFolder.open(folder, report.getFileName().toString())) {
            new ResultPage(check.command(), checked.subject() + ": " + checked.identity(), checked.paragraphs(),
                    checked.pictures(), checked.tables()).write(files, check.format().quick());
        }
        return report;
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
