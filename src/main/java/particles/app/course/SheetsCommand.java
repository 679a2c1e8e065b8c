package particles.app.course;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import particles.app.cli.ResultsCommand;
import particles.output.files.OutputFolder;
import particles.output.report.Html;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercises;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * {@code gradle sheets -Pstudents=list.csv -Pkey=key.txt}: a printable page for each student, with numbers that follow
 * from the id and the secret in the key file, which is made if it is not there.
 */
@Command(name = "sheets", description = "Writes a printable sheet of exercises for each student of a class.")
public final class SheetsCommand extends ResultsCommand {
    private static final int BYTES = 32;
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
        Assignment assignment = course.readAssignment();
        Path key = course.getKey().orElseThrow(() -> wrong("key", "is needed: this makes the file, or uses it again"));
        if (!Files.exists(key)) {
            byte[] secret = new byte[BYTES];
            new SecureRandom().nextBytes(secret);
            Files.writeString(key, HexFormat.of().formatHex(secret) + "\n");
        }
        Function<String, Optional<String>> numbers = course.numbersOf(assignment);
        try (OutputFolder files = OutputFolder.open(getFolder())) {
            int sheet = 0;
            for (ClassList.Student each : ClassList.read(students).students().values()) {
                String own = numbers.apply(each.id()).orElseThrow();
                sheet++;
                files.write("sheet-" + sheet + "-" + each.id().replaceAll("[^\\w-]", "_") + ".html",
                        Html.fill(PAGE, Map.of("student", each.id(), "parts", assignment.exercises().keySet().stream()
                        .map(number -> Map.of("number", number, "title", Exercises.ALL.get(number - 1).title(), "text",
                        Exercises.ALL.get(number - 1).text(new Draw(own, number)))).toList())));
            }
            out.println(sheet + " sheets: " + getFolder() + "; mark with " + getStyle().option("key") + "=" + key);
        }
    }
}
