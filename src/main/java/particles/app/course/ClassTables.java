package particles.app.course;

import static particles.view.DataTable.column;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import particles.app.cli.Program;
import particles.app.course.ClassList.Column;
import particles.app.course.ClassList.Student;
import particles.app.course.Result.Item;
import particles.app.course.Result.State;
import particles.app.course.Result.Status;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.Report;
import particles.output.report.ResultPage;
import particles.teaching.exercises.Draw;
import particles.view.DataTable;

/** The tables of a class: for people class.html, class.md and CSV; for Moodle its grading worksheet. */
final class ClassTables {
    private static final String WORKSHEET = "worksheet.csv";

    private final ClassList list;
    private final List<Result> results;

    /** A mark of a student. */
    private record Row(Student student, Item item) {
    }

    /**
     * @param list tells names and addresses
     * @param all  the results, one or more for each student, of which the latest counts
     */
    ClassTables(ClassList list, List<Result> all) {
        this.list = list;
        Map<String, Result> latest = new TreeMap<>();
        all.stream().sorted(Comparator.comparing(Result::date).thenComparing(Result::handIn)).forEach(result ->
                latest.put(result.student() + '\0' + result.state(), result));
        results = latest.values().stream().sorted(Comparator.comparing(Result::state)).toList();
    }

    private static String remarks(Result result) {
        return Stream.concat(result.problems().stream().limit(2), result.tests().stream().filter(item ->
                item.status() == Status.ERROR).map(item -> item.name() + " is not decided: run this again")).collect(
                Collectors.joining("; "));
    }

    /**
     * Writes all files.
     *
     * @return lines for the screen: first each hand-in at which a person has to look
     */
    List<String> write(OutputFolder files) {
        List<Row> rows = results.stream().flatMap(result -> result.tests().stream().map(item -> new Row(list.student(
                result.student()), item))).toList();
        DataTable each = DataTable.of("students", "Students", results,
                column("state", result -> result.state().words()), column("student", Result::student),
                column("name", result -> list.student(result.student()).name()),
                column("e-mail", result -> list.student(result.student()).mail()),
                column("participant", result -> list.student(result.student()).number()),
                column("points", result -> result.tests().isEmpty() ? "" : result.points()),
                column("of", result -> result.tests().isEmpty() ? "" : result.maxScore()),
                column("latest file", Result::date), column("hand-in", Result::handIn),
                column("remarks", ClassTables::remarks)).withoutEmptyColumns();
        DataTable all = DataTable.of("class", "All marks", rows, column("student", row -> row.student().id()),
                column("name", row -> row.student().name()), column("exercise", row -> row.item().name()),
                column("points", row -> row.item().score()), column("of", row -> row.item().maxScore()),
                column("mistake", row -> row.item().mistake())).withoutEmptyColumns();
        Map<String, Long> counts = rows.stream().filter(row -> row.item().answered()
                && !row.item().mistake().isEmpty()).map(row -> row.item().name() + ": " + row.item().mistake())
                .collect(Collectors.groupingBy(Function.identity(), TreeMap::new, Collectors.counting()));
        DataTable common = DataTable.of("mistakes", "The commonest mistakes", counts.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed()).toList(),
                column("students", Map.Entry::getValue), column("mistake", Map.Entry::getKey));
        ResultPage page = new ResultPage("class", Draw.text(results.stream().mapToDouble(Result::points).sum())
                + " points for " + results.size() + " students", list.remarks(), List.of(), List.of(each, common, all));
        page.write(files, ChartFormat.PAGE);
        new Report(page.title(), List.of(), List.of(new Report.Section(GradeClassCommand.NAME,
                "marks the hand-ins of a class", files.getPath(), Optional.of(page), Optional.empty())),
                "version " + Program.VERSION).write(files, "class.html");
        if (Column.GRADE.place(list.head()) >= 0 && Column.NUMBER.place(list.head()) >= 0) {
            files.write(WORKSHEET, CSVFormat.DEFAULT.format(list.head().toArray()) + "\n" + list.students().values()
                    .stream().map(this::graded).collect(Collectors.joining()));
        }
        return Stream.concat(results.stream().filter(result -> result.state() != State.MARKED).map(Result::reason),
                Stream.of(results.size() + " students; table: " + files.getPath().resolve("class.html"))).toList();
    }

    /** A student's line of Moodle's grading worksheet; where there are no marks, the grade is left as it is. */
    private String graded(Student student) {
        List<String> cells = new ArrayList<>(student.cells());
        results.stream().filter(result -> result.state() == State.MARKED && result.status() != Status.ERROR
                && result.student().equals(student.id())).findFirst().ifPresent(result -> {
            String most = list.cell(cells, Column.MOST).replace(',', '.');
            double scale = result.maxScore() > 0 && most.matches("[\\d.]+")
                    ? Double.parseDouble(most) / result.maxScore() : 1;
            cells.set(Column.GRADE.place(list.head()), String.format(Locale.ROOT, "%.2f", scale * result.points()));
        });
        return CSVFormat.DEFAULT.format(cells.toArray()) + "\n";
    }
}
