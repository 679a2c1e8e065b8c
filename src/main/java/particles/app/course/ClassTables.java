package particles.app.course;

import static particles.view.DataTable.column;

import java.nio.file.Path;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import particles.app.cli.Program;
import particles.app.course.Result.HandIn;
import particles.app.course.Result.Item;
import particles.app.course.Result.Status;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.Report;
import particles.output.report.ResultPage;
import particles.view.DataTable;

/** Writes the tables of a class: class.csv, class.html and class.md. */
final class ClassTables {
    static final List<String> FILES = List.of("class.md", "class.csv", "students.csv", "mistakes.csv", "talk.csv",
            "class.html");
    private static final int MOST_COMMON = 10;
    private static final double SECONDS_PER_HOUR = 3600;

    private final Assignment assignment;
    private final List<Result> results;

    /** A mark of a student. */
    private record Row(Result result, Item item) {
    }

    /**
     * @param assignment tells the deadline
     * @param all        the results, one or more for each student
     * @param best       whether a student's best hand-in counts, and not the last one
     */
    ClassTables(Assignment assignment, List<Result> all, boolean best) {
        this.assignment = assignment;
        Comparator<Result> byDate = Comparator.comparing(result -> result.handIn().date());
        Comparator<Result> order = best ? Comparator.comparingDouble(Result::points).thenComparing(byDate) : byDate;
        results = new ArrayList<>(new TreeMap<>(all.stream().collect(Collectors.toMap(Result::student,
                Function.identity(), (a, b) -> order.compare(a, b) > 0 ? a : b))).values());
    }

    /** @return a whole number without a point */
    static Object number(double points) {
        return points == Math.rint(points) ? (Object) Math.round(points) : points;
    }

    private static String date(HandIn handIn) {
        return handIn.name().isEmpty() ? "" : handIn.date().truncatedTo(ChronoUnit.SECONDS).toString();
    }

    /** Hours after the deadline; empty if in time. */
    private String late(HandIn handIn) {
        return assignment.deadline().map(OffsetDateTime::toInstant).filter(deadline -> !handIn.name().isEmpty()
                && handIn.date().isAfter(deadline)).map(deadline -> String.format(Locale.ROOT, "%.1f",
                Duration.between(deadline, handIn.date()).toSeconds() / SECONDS_PER_HOUR)).orElse("");
    }

    /** @return each student to talk to, and why */
    private List<Map.Entry<String, String>> toTalkTo() {
        List<Map.Entry<String, String>> whom = new ArrayList<>();
        for (Result result : results) {
            List<String> why = new ArrayList<>();
            if (result.handIn().name().isEmpty()) {
                why.add("nothing was handed in");
            } else {
                String late = late(result.handIn());
                why.add(result.points() == 0 && result.most() > 0 ? "no points" : "");
                why.add(late.isEmpty() ? "" : "late by " + late + " h");
                why.addAll(result.problems().stream().limit(2).toList());
            }
            why.add(result.items().stream().filter(item -> item.status() == Status.ERROR).map(item -> item.name()
                    + " is not decided: run this again").collect(Collectors.joining("; ")));
            why.stream().filter(reason -> !reason.isEmpty()).forEach(reason ->
                    whom.add(Map.entry(result.student(), reason)));
        }
        whom.addAll(Copies.toLookAt(new TreeMap<>(results.stream().collect(Collectors.toMap(Result::student,
                Result::classes)))));
        whom.sort(Map.Entry.comparingByKey());
        return whom;
    }

    /** @return the number of students, in words, and what there is to say about hand-ins */
    String write(OutputFolder files, Path folder, Collection<String> problems) {
        List<Row> rows = results.stream().flatMap(result -> result.items().stream().map(item -> new Row(result, item)))
                .toList();
        DataTable all = DataTable.of("class", "All marks", rows,
                column("student", row -> row.result().student()), column("exercise", row -> row.item().name()),
                column("points", row -> number(row.item().points())),
                column("of", row -> number(row.item().weight())), column("mistake", row -> row.item().mistake()),
                column("attempt", row -> row.result().handIn().name()),
                column("handed in", row -> date(row.result().handIn())),
                column("late (h)", row -> late(row.result().handIn())),
                column("version", row -> row.result().program()));
        DataTable each = DataTable.of("students", "Students", results,
                column("student", Result::student),
                column("points", result -> number(result.points())),
                column("of", result -> number(result.most())),
                column("handed in", result -> date(result.handIn())),
                column("late (h)", result -> late(result.handIn())),
                column("attempt", result -> result.handIn().name()));
        Map<String, Long> counts = rows.stream().filter(row -> row.item().answered()
                && !row.item().mistake().isEmpty()).map(row -> row.item().name() + ": " + row.item().mistake())
                .collect(Collectors.groupingBy(Function.identity(), TreeMap::new, Collectors.counting()));
        DataTable common = DataTable.of("mistakes", "The commonest mistakes", counts.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed()).limit(MOST_COMMON).toList(),
                column("students", Map.Entry::getValue), column("mistake", Map.Entry::getKey));
        DataTable talk = DataTable.of("talk", "Students to talk to", toTalkTo(), column("student",
                Map.Entry::getKey), column("why", Map.Entry::getValue));
        List<String> text = new ArrayList<>(problems);
        text.add("Nobody lost a mark for a class that is like another or uses a solver of the project: compare these"
                + " classes yourself. JPlag compares more closely.");
        ResultPage page = new ResultPage("class", number(results.stream().mapToDouble(Result::points).sum())
                + " points for " + results.size() + " students", text, List.of(), List.of(each, talk, common, all));
        page.write(files, ChartFormat.PAGE);
        new Report(page.title(), List.of(), List.of(new Report.Section(GradeClassCommand.NAME,
                "marks the hand-ins of a class", folder, 0, Optional.of(page), Optional.empty())),
                "version " + Program.VERSION).write(files, "class.html");
        return results.size() + " students; table: " + folder.resolve("class.html");
    }
}
