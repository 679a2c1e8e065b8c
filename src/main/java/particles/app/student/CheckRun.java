package particles.app.student;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.student.Check.Checked;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.files.StopHook;
import particles.output.report.ResultPage;
import particles.output.report.TableText;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;

/**
 * Makes a check with a limit on its CPU time, and writes its report.
 *
 * @param check  the check
 * @param folder receives the report
 * @param screen shows the verdict and the check's own lines
 */
record CheckRun(Check check, Path folder, BiConsumer<ExitCode, List<String>> screen) {
    private static final double SECONDS = 7;
    private static final int MOST_LINES = 12;
    private static final int MOST_FINDINGS = 6;
    private static final int LONGEST = 100;

    /** @return the verdict */
    ExitCode run() {
        GuardedRun guard = new GuardedRun(SECONDS);
        StopHook hook = new StopHook(() -> guard.endedAt().ifPresent(place -> giveUp(new Finding(Kind.FAILURE,
                "the class ends the whole program (System.exit)" + place), "")));
        PrintStream before = System.out;
        Printed printed = new Printed();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        Outcome<Checked> outcome = guard.run(check::make);      // which throws nothing
        System.setOut(before);
        hook.close();
        outcome.failure().ifPresent(failure -> giveUp(failure, printed.text()));
        return show(outcome.value().orElseThrow(), printed.text());
    }

    /** Reports a check that did not finish, and ends the process, in which the class's thread may still be running. */
    private void giveUp(Finding failure, String printed) {
        Runtime.getRuntime().halt(show(new Checked(check.subject(), "The check did not finish.", List.of(failure)),
                printed).code());
    }

    /** Writes the report and shows the verdict. */
    private ExitCode show(Checked checked, String printed) {
        ExitCode code = checked.isRight() ? ExitCode.DONE : checked.findings().stream().allMatch(finding ->
                !finding.isWrong() || finding.kind() == Kind.UNDECIDED) ? ExitCode.STOPPED : ExitCode.BAD_INPUT;
        List<String> lines;
        try {
            lines = lines(checked, printed, write(checked));
        } catch (OutputException e) {
            lines = List.of(e.getMessage());
            code = ExitCode.TROUBLE;
        }
        screen.accept(code, lines);
        return code;
    }

    /** Writes the report, and returns its file. */
    private Path write(Checked checked) {
        Path report = check.report(folder);
        try (OutputFolder files = OutputFolder.open(folder, report.getFileName().toString())) {
            new ResultPage(check.command(), checked.subject() + ": " + checked.identity(), checked.paragraphs(),
                    checked.pictures(), checked.tables()).write(files, check.format().quick());
        }
        return report;
    }

    /** The output on the screen, in at most twelve lines: the verdict, mistakes and notes, numbers, and the report. */
    private static List<String> lines(Checked checked, String printed, Path report) {
        Optional<Finding> unwritten = checked.findings().stream().filter(finding -> finding.kind() == Kind.UNWRITTEN)
                .findFirst();
        if (unwritten.isPresent()) {
            return List.of(checked.subject() + ": " + unwritten.get().text());
        }
        List<String> lines = new ArrayList<>(List.of(checked.subject() + ": " + (checked.identity().equals(
                Checked.NOT_CHECKED) ? "" : verdict(checked.findings())) + checked.identity()));
        checked.findings().stream().sorted(Comparator.comparing(Finding::isWrong).reversed()).limit(MOST_FINDINGS)
                .map(CheckRun::line).forEach(lines::add);
        List<String> text = printed.strip().lines().toList();
        List<String> last = Stream.concat(text.stream().limit(1).map(first -> "the class printed: " + first.substring(0,
                Math.min(LONGEST, first.length())) + (text.size() > 1 ? " (and more lines)" : "")), Stream.of("report: "
                + report)).toList();
        checked.tables().stream().limit(1).flatMap(table -> TableText.plain(table).stream()).limit(MOST_LINES
                - lines.size() - last.size()).forEach(lines::add);
        lines.addAll(last);
        return lines;
    }

    private static String verdict(List<Finding> findings) {
        return findings.stream().filter(Finding::isWrong).map(finding -> switch (finding.kind()) {
            case NAME -> "not what its name says. ";
            case UNDECIDED -> "not decided. ";
            default -> "wrong. ";
        }).findFirst().orElse("right. ");
    }

    /** Capitals for what costs the mark. */
    private static String line(Finding finding) {
        return switch (finding.kind()) {
            case STYLE, UNDECIDED -> "";
            case NAME -> "PROMISE, ";
            default -> "WRONG, ";
        } + finding;
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
