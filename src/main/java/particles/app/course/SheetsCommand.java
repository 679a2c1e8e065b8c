package particles.app.course;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.UUID;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import particles.app.cli.ResultsCommand;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.report.Html;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercises;
import particles.teaching.exercises.NumericExercise;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * {@code gradle sheets -Pstudents=list.csv -Pkey=key.csv}: a printable page for each student, with numbers that follow
 * from a secret in the key file and not from the id. Students who are in the key file already keep their numbers.
 */
@Command(name = "sheets", description = "Writes a printable sheet of exercises for each student of a class.")
public final class SheetsCommand extends ResultsCommand {
    private static final String HEAD = "student,secret (keep this file from students)";
    private static final int MOST_DRAWS = 100;
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

    @Override
    public void run(PrintWriter out) throws Exception {
        Set<Integer> wanted = course.readAssignment().exercises().keySet();
        Path key = course.getKey().orElseThrow(() -> wrong("key", "give the key file; it is created if it does"
                + " not exist"));
        Map<String, String> secrets = Files.exists(key) ? CourseOptions.secrets(key)
                : new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        List<List<Double>> taken = new ArrayList<>();
        secrets.values().forEach(secret -> taken.add(answers(wanted, secret)));
        try (OutputFolder files = OutputFolder.open(getFolder())) {
            int sheet = 0;
            for (ClassList.Student each : ClassList.read(students).students().values()) {
                String secret = secrets.computeIfAbsent(each.id(), id -> secret(id, wanted, taken, out));
                sheet++;
                files.write("sheet-" + sheet + "-" + each.id().replaceAll("[^\\w-]", "_") + ".html", Html.fill(PAGE,
                        Map.of("student", each.id(), "parts", wanted.stream().map(number -> Map.of("number", number,
                        "title", Exercises.ALL.get(number - 1).title(), "text", Exercises.ALL.get(number - 1).text(
                        new Draw(secret, number)))).toList())));
            }
            List<String> lines = new ArrayList<>(List.of(HEAD));
            secrets.forEach((student, secret) -> lines.add(CSVFormat.DEFAULT.format(student, secret)));
            OutputFile.write(key, (String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8));
            out.println(sheet + " sheets: " + getFolder() + "; mark with " + getStyle().option("key") + "=" + key);
        }
    }

    /** The answers to the exercises that are numbers. */
    private static List<Double> answers(Set<Integer> wanted, String secret) {
        return wanted.stream().flatMap(number -> Exercises.ALL.get(number - 1) instanceof NumericExercise numeric
                ? Stream.of(numeric.worked(new Draw(secret, number)).answer()) : Stream.empty()).toList();
    }

    /** A secret with which no answer is right for somebody else; if none is found, the lecturer is told. */
    static String secret(String id, Set<Integer> wanted, List<List<Double>> taken, PrintWriter out) {
        for (int draw = 1;; draw++) {
            String secret = UUID.randomUUID().toString();
            List<Double> mine = answers(wanted, secret);
            if (draw == MOST_DRAWS) {
                out.println(id + ": an answer may also be right for another student");
            }
            if (draw == MOST_DRAWS || taken.stream().noneMatch(other -> IntStream.range(0, mine.size()).anyMatch(k ->
                    NumericExercise.isNear(other.get(k), mine.get(k)) || NumericExercise.isNear(mine.get(k),
                    other.get(k))))) {
                taken.add(mine);
                return secret;
            }
        }
    }
}
