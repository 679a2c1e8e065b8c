package particles.app.student;

import java.io.PrintWriter;
import java.nio.file.Files;
import particles.app.cli.ExitCode;
import particles.app.cli.ExitCode.Failure;
import particles.app.cli.ResultsCommand;

/** A command that checks a student's class, in a process of its own. */
abstract class CheckCommand extends ResultsCommand {
    /** @return the check that is asked for */
    abstract Check check();

    @Override
    public final void run(PrintWriter lines) throws Exception {
        Check check = check();
        Files.deleteIfExists(check.report(getFolder()));
        StudentProcess.Outcome outcome = StudentProcess.run(check, getFolder(), StudentLoader.installed());
        outcome.lines().forEach(lines::println);
        if (outcome.code() != ExitCode.DONE) {
            throw new Failure(outcome.code(), "");
        }
    }
}
