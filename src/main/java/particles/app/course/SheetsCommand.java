package particles.app.course;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import particles.app.cli.ResultsCommand;
import particles.output.files.OutputFolder;
import particles.output.report.Html;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercise;
import particles.teaching.exercises.Exercises;
import particles.teaching.exercises.NumericExercise;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * {@code gradle sheets -Pstudents=list.csv -Pkey=key.csv}: a printable page for each student, with numbers that follow
 * from the key file and not from the id. Students who are in the key file already keep their numbers.
 */
@Command(name = "sheets", description = "Writes a printable sheet of exercises for each student of a class.")
public final class SheetsCommand extends ResultsCommand {
    private static final String HEAD = "student,the secret of each exercise (keep this file from students)";
    private static final int MOST_DRAWS = 100;
    private static final int BYTES = 8;
    private static final String PAGE = """
            <!DOCTYPE html>
            <html lang="en"><head><meta charset="utf-8"/><title>Exercises for {{student}}</title>
            <style>body { max-width: 45em; margin: 2em auto; font: 12pt serif } p { white-space: pre-wrap }
            section { break-inside: avoid }</style></head><body><h1>Exercises for {{student}}</h1>
            {{#parts}}
            <section><h2>{{number}}. {{title}}</h2><p>{{text}}</p></section>
            {{/parts}}
            </body></html>
            """;

    @Option(names = "--students", paramLabel = "FILE", required = true,
            description = "The list of students, as for gradeClass.")
    private Path students;

    @Mixin
    private final CourseOptions course = new CourseOptions();

    private final SecureRandom random = new SecureRandom();

    @Override
    public void run(PrintWriter out) throws Exception {
        Map<Integer, Double> wanted = course.readAssignment().exercises();
        Path key = course.getKey().orElseThrow(() -> wrong("key", "the file is missing that this makes, or adds to"));
        Map<String, List<String>> keys = Files.exists(key) ? CourseOptions.key(key)
                : new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        List<List<Double>> taken = IntStream.rangeClosed(0, Exercises.ALL.size())
                .<List<Double>>mapToObj(number -> new ArrayList<>()).toList();
        keys.values().forEach(secrets -> wanted.keySet().forEach(number ->
                answer(number, secrets.get(number)).forEach(taken.get(number)::add)));
        try (OutputFolder files = OutputFolder.open(getFolder())) {
            int sheet = 0;
            for (ClassList.Student each : ClassList.read(students).students().values()) {
                String student = each.id();
                List<String> secrets = keys.computeIfAbsent(student, id -> Stream.concat(Stream.of(id), IntStream
                        .rangeClosed(1, Exercises.ALL.size()).mapToObj(number -> secret(number,
                        taken.get(number)))).toList());
                sheet++;
                files.write("sheet-" + sheet + "-" + student.replaceAll("[^\\w-]", "_") + ".html",
                        Html.fill(PAGE, Map.of("student", student, "parts", wanted.keySet().stream().map(number ->
                        Map.of("number", number, "title", Exercises.ALL.get(number - 1).title(), "text",
                        Exercises.ALL.get(number - 1).text(new Draw(secrets.get(number), number)))).toList())));
            }
            List<String> lines = new ArrayList<>(List.of(HEAD));
            keys.values().forEach(cells -> lines.add(CSVFormat.DEFAULT.format(cells.toArray())));
            Path whole = key.resolveSibling(key.getFileName() + ".new");
            Files.write(whole, lines);
            Files.move(whole, key, StandardCopyOption.REPLACE_EXISTING);
            out.println(sheet + " sheets: " + getFolder() + "; mark with " + getStyle().option("key") + "=" + key);
        }
    }

    private static Stream<Double> answer(int number, String secret) {
        Exercise exercise = Exercises.ALL.get(number - 1);
        return exercise instanceof NumericExercise numeric
                ? Stream.of(numeric.worked(new Draw(secret, number)).answer()) : Stream.empty();
    }

    /** A secret with which no answer is right for somebody else, as far as there is one. */
    private String secret(int number, List<Double> taken) {
        byte[] bytes = new byte[BYTES];
        for (int draw = 1;; draw++) {
            random.nextBytes(bytes);
            String secret = HexFormat.of().formatHex(bytes);
            List<Double> mine = answer(number, secret).toList();
            if (draw == MOST_DRAWS || mine.stream().noneMatch(own -> taken.stream().anyMatch(other ->
                    NumericExercise.isNear(other, own) || NumericExercise.isNear(own, other)))) {
                taken.addAll(mine);
                return secret;
            }
        }
    }
}
