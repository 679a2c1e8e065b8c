package particles.app.student;

import java.nio.file.Path;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.student.Check.Checked;
import particles.output.charts.ChartFormat;
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

    /** @return the verdict */
    ExitCode run() {
        GuardedRun guard = new GuardedRun(SECONDS);
        StopHook hook = new StopHook(() -> guard.endedAt().ifPresent(place -> giveUp(new Finding(Kind.FAILURE,
                "the class ends the whole program (System.exit)" + place))));
        Outcome<Checked> outcome = guard.run(check::make);      // which throws nothing
        hook.close();
        outcome.failure().ifPresent(this::giveUp);
        return show(outcome.value().orElseThrow());
    }

    /** Reports a check that did not finish, and ends the process, in which the class's thread may still be running. */
    private void giveUp(Finding failure) {
        Runtime.getRuntime().halt(show(new Checked(check.subject(), "The check did not finish.", List.of(failure)))
                .code());
    }

    /** Writes the report and shows the verdict. */
    private ExitCode show(Checked checked) {
        ExitCode code = checked.isRight() ? ExitCode.DONE : checked.findings().stream().allMatch(finding ->
                !finding.isWrong() || finding.kind() == Kind.UNDECIDED) ? ExitCode.STOPPED : ExitCode.BAD_INPUT;
        Path report = check.report(folder);
        List<String> lines;
        try (OutputFolder files = OutputFolder.open(folder)) {
            new ResultPage(check.command(), checked.subject() + ": " + checked.identity(), checked.lines().stream()
                    .map(line -> "- " + line).toList(), checked.pictures(), checked.tables()).write(files,
                    ChartFormat.PAGE.quick());
            lines = lines(checked, report);
        } catch (OutputException e) {
            lines = List.of(e.getMessage());
            code = ExitCode.TROUBLE;
        }
        screen.accept(code, lines);
        return code;
    }

    /** The output on the screen: the verdict, mistakes and notes, the numbers, and the report. */
    private static List<String> lines(Checked checked, Path report) {
        return Stream.of(Stream.of(checked.subject() + ": " + verdict(checked.findings()) + checked.identity()),
                checked.lines().stream(), checked.tables().stream().flatMap(table -> TableText.plain(table).stream()),
                Stream.of("report: " + report)).flatMap(lines -> lines).toList();
    }

    private static String verdict(List<Finding> findings) {
        return findings.stream().filter(Finding::isWrong).map(finding -> switch (finding.kind()) {
            case NAME -> "not what its name says. ";
            case UNDECIDED -> "not decided. ";
            case UNWRITTEN -> "not written yet. ";
            default -> "wrong. ";
        }).findFirst().orElse("right. ");
    }
}
