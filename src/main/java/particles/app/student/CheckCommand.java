package particles.app.student;

import java.io.PrintWriter;
import java.nio.file.Files;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.ResultsCommand;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import picocli.CommandLine.Option;

/** A command that checks a student's class, in a process of its own. */
abstract class CheckCommand extends ResultsCommand {
    @Option(names = "--inThisProcess", hidden = true, description = "Checks here, as the process that was made for it.")
    private boolean inThisProcess;

    /** @return the check that is asked for */
    abstract Check check();

    @Override
    public final void run(PrintWriter lines) throws Exception {
        Check check = check();
        CheckRun here = new CheckRun(check, getFolder(), (code, report) -> report.forEach(lines::println));
        ExitCode code;
        if (inThisProcess) {
            code = here.run();
        } else {
            Files.deleteIfExists(check.report(getFolder()));
            StudentProcess.Outcome outcome = StudentProcess.run(check, getFolder(), StudentLoader.installed());
            code = outcome.code();
            if (!Files.exists(check.report(getFolder()))) {     // its process was ended before it wrote one
                here.write(new Finding(code == ExitCode.STOPPED ? Kind.UNDECIDED : Kind.FAILURE, String.join(" ",
                        outcome.lines()).replaceFirst("^(wrong|not decided): ", "")));
            }
            outcome.lines().forEach(lines::println);
        }
        if (code != ExitCode.DONE) {
            throw new Failure(code, "");
        }
    }
}
