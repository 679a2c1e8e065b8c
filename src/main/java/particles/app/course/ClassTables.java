package particles.app.course;

import static particles.view.DataTable.column;

import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
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
import particles.view.DataTable;

/** The tables of a class: for people class.html, class.md and CSV; for Moodle its grading worksheet. */
final class ClassTables {
    private static final String WORKSHEET = "worksheet.csv";
    static final List<String> FILES = List.of("class.md", "class.csv", "students.csv", "mistakes.csv", "class.html",
            WORKSHEET);
    private static final int MOST_COMMON = 10;
    private static final double SECONDS_PER_HOUR = 3600;

    private final Assignment assignment;
    private final ClassList list;
    private final List<Result> results;

    /** A mark of a student. */
    private record Row(Result result, Student student, Item item) {
    }

    /**
     * @param assignment tells the deadline
     * @param list       tells names and addresses
     * @param all        the results, one or more for each student
     * @param attempt    which of a student's hand-ins counts
     */
    ClassTables(Assignment assignment, ClassList list, List<Result> all, GradeClassCommand.Attempt attempt) {
        this.assignment = assignment;
        this.list = list;
        Comparator<Result> byDate = Comparator.comparing(Result::instant).thenComparing(Result::handIn);
        Comparator<Result> order = attempt == GradeClassCommand.Attempt.BEST ? Comparator.comparingDouble(
                Result::points).thenComparing(byDate) : byDate;
        results = all.stream().collect(Collectors.toMap(result -> result.student() + '\0' + result.state(),
                Function.identity(), (a, b) -> order.compare(a, b) > 0 ? a : b, TreeMap::new)).values().stream()
                .sorted(Comparator.comparing(Result::state)).toList();
    }

    /** @return a whole number without a point */
    static Object number(double points) {
        return points == Math.rint(points) ? (Object) Math.round(points) : points;
    }

    /** Hours after the deadline; empty if in time. */
    private String late(Result result) {
        return assignment.deadline().map(OffsetDateTime::toInstant).filter(result.instant()::isAfter).map(deadline ->
                String.format(Locale.ROOT, "%.1f", Duration.between(deadline, result.instant()).toSeconds()
                / SECONDS_PER_HOUR)).orElse("");
    }

    private static String remarks(Result result) {
        return Stream.of(result.problems().stream().limit(2), Stream.of("no points").filter(none ->
                result.state() == State.MARKED && result.points() == 0 && result.maxScore() > 0),
                result.tests().stream().filter(item -> item.status() == Status.ERROR).map(item -> item.name()
                + " is not decided: run this again")).flatMap(lines -> lines).collect(Collectors.joining("; "));
    }

    /**
     * Writes all files.
     *
     * @return lines for the screen: first each hand-in at which a person has to look
     */
    List<String> write(OutputFolder files) {
        List<Row> rows = results.stream().flatMap(result -> result.tests().stream().map(item -> new Row(result,
                list.student(result.student()), item))).toList();
        DataTable each = DataTable.of("students", "Students", results,
                column("state", result -> result.state().words()), column("student", Result::student),
                column("name", result -> list.student(result.student()).name()),
                column("e-mail", result -> list.student(result.student()).mail()),
                column("participant", result -> list.student(result.student()).number()),
                column("points", result -> result.tests().isEmpty() ? "" : number(result.points())),
                column("of", result -> result.tests().isEmpty() ? "" : number(result.maxScore())),
                column("handed in", result -> result.instant().equals(Instant.EPOCH) ? ""
                : result.instant().truncatedTo(ChronoUnit.SECONDS).toString()), column("late (h)", this::late),
                column("attempt", Result::handIn), column("remarks", ClassTables::remarks)).withoutEmptyColumns();
        DataTable all = DataTable.of("class", "All marks", rows, column("student", row -> row.student().id()),
                column("name", row -> row.student().name()), column("exercise", row -> row.item().name()),
                column("points", row -> number(row.item().score())),
                column("of", row -> number(row.item().maxScore())), column("mistake", row -> row.item().mistake()),
                column("version", row -> row.result().program())).withoutEmptyColumns();
        Map<String, Long> counts = rows.stream().filter(row -> row.item().answered()
                && !row.item().mistake().isEmpty()).map(row -> row.item().name() + ": " + row.item().mistake())
                .collect(Collectors.groupingBy(Function.identity(), TreeMap::new, Collectors.counting()));
        DataTable common = DataTable.of("mistakes", "The commonest mistakes", counts.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed()).limit(MOST_COMMON).toList(),
                column("students", Map.Entry::getValue), column("mistake", Map.Entry::getKey));
        ResultPage page = new ResultPage("class", number(results.stream().mapToDouble(Result::points).sum())
                + " points for " + results.size() + " students", list.remarks(), List.of(), List.of(each, common, all));
        page.write(files, ChartFormat.PAGE);
        new Report(page.title(), List.of(), List.of(new Report.Section(GradeClassCommand.NAME,
                "marks the hand-ins of a class", files.getPath(), 0, Optional.of(page), Optional.empty())),
                "version " + Program.VERSION).write(files, "class.html");
        if (Column.GRADE.place(list.head()) >= 0 && Column.NUMBER.place(list.head()) >= 0) {
            files.write(WORKSHEET, CSVFormat.DEFAULT.format(list.head().toArray()) + "\n" + list.students().values()
                    .stream().map(this::graded).collect(Collectors.joining()));
        }
        return Stream.concat(results.stream().filter(result -> result.state() != State.MARKED).map(result ->
                result.state().words() + ": " + result.student() + result.problems().stream().map(line -> ", " + line)
                .collect(Collectors.joining())), Stream.of(results.size() + " students; table: " + files.getPath()
                .resolve("class.html"))).toList();
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
