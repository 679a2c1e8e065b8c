package particles.app.student;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import particles.output.charts.ChartFormat;
import particles.output.report.Picture;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.view.DataTable;

/**
 * A check of a student's class, which can be sent to another process.
 *
 * @param command the name of its command
 * @param subject the name of the class, as typed
 * @param method  the method that a solver has to be; empty for an effect
 * @param format  the format of its charts
 */
public record Check(String command, String subject, String method, ChartFormat format) {
    /** @return what {@link #of} needs to make it again in another process */
    List<String> words() {
        return List.of(command, subject, method, format.slide() + "", format.svg() + "", format.dark() + "");
    }

    /** @return the check of these {@link #words} */
    static Check of(List<String> words) {
        return new Check(words.get(0), words.get(1), words.get(2),
                new ChartFormat(words.get(3).equals("true"), words.get(4).equals("true"), words.get(5).equals("true")));
    }

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
