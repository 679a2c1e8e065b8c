package particles.app.student;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import particles.output.report.Picture;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.view.DataTable;

/**
 * A check of a student's class.
 *
 * @param command the name of its command
 * @param subject the name of the class, as typed
 * @param method  the method that a solver has to be; empty for an effect
 */
public record Check(String command, String subject, String method) {
    /** Makes it; runs the class's own code. */
    Checked make() {
        return command.equals(CheckSolverCommand.NAME) ? CheckSolverCommand.checked(subject, method)
                : CheckEffectCommand.checked(subject);
    }

    /** @return the file of its report in this folder */
    Path report(Path folder) {
        return folder.resolve(command + ".md");
    }

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
        /** A result without pictures and tables. */
        Checked(String subject, String identity, List<Finding> findings) {
            this(subject, identity, findings, List.of(), List.of());
        }

        /** A class that cannot be checked, for this reason. */
        Checked(String subject, Exception reason) {
            this(subject, "It cannot be checked.", List.of(new Finding(Kind.FAILURE,
                    String.valueOf(reason.getMessage()))));
        }

        boolean isRight() {
            return findings.stream().noneMatch(Finding::isWrong);
        }

        /** @return a line for each finding, mistakes first; capitals for what costs the mark */
        List<String> lines() {
            return findings.stream().sorted(Comparator.comparing(Finding::isWrong).reversed()).map(finding -> switch (
                    finding.kind()) {
                case STYLE, UNDECIDED, UNWRITTEN -> "";
                case NAME -> "PROMISE, ";
                default -> "WRONG, ";
            } + finding).toList();
        }
    }
}
