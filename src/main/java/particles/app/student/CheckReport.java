package particles.app.student;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.app.student.Check.Checked;
import particles.output.report.TableText;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.view.DataTable;

/** The output of a check on the screen: the verdict, then mistakes, notes and numbers, in at most twelve lines. */
final class CheckReport {
    static final int MOST_LINES = 12;
    private static final int MOST_MISTAKES = 4;
    private static final int MOST_NOTES = 2;
    private static final int LONGEST = 100;

    private CheckReport() {
    }

    /**
     * @param checked the result of the check
     * @param printed the text that the class printed
     * @param report  the file of the whole report
     * @return the lines
     */
    static List<String> lines(Checked checked, String printed, Path report) {
        Optional<Finding> unwritten = checked.findings().stream().filter(finding -> finding.kind() == Kind.UNWRITTEN)
                .findFirst();
        if (unwritten.isPresent()) {
            return List.of(checked.subject() + ": " + unwritten.get().text());
        }
        List<String> lines = new ArrayList<>(List.of(checked.subject() + ": " + (checked.identity().equals(
                Checked.NOT_CHECKED) ? "" : verdict(checked.findings())) + checked.identity()));
        add(lines, checked.findings().stream().filter(Finding::isWrong).toList(), MOST_MISTAKES);
        add(lines, checked.findings().stream().filter(finding -> !finding.isWrong()).toList(), MOST_NOTES);
        List<String> last = new ArrayList<>();
        if (!printed.isBlank()) {
            List<String> text = printed.strip().lines().toList();
            String first = text.get(0).length() > LONGEST ? text.get(0).substring(0, LONGEST) + "..." : text.get(0);
            last.add("the class printed: " + first + (text.size() > 1 ? " (and more lines)" : ""));
        }
        last.add("report: " + report);
        List<DataTable> tables = checked.tables();
        int room = MOST_LINES - lines.size() - last.size();
        if (!tables.isEmpty() && room > 1) {
            lines.addAll(TableText.plain(tables.get(0)).stream().limit(room).toList());
        }
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

    private static void add(List<String> lines, List<Finding> findings, int most) {
        findings.stream().limit(most).map(CheckReport::line).forEach(lines::add);
        if (findings.size() > most) {
            lines.add(lines.remove(lines.size() - 1) + " (" + (findings.size() - most) + " more in the report)");
        }
    }
}
