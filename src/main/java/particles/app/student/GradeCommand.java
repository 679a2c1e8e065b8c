package particles.app.student;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.ProgramCommand;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.JUnitXml;
import particles.output.report.ResultPage;
import particles.output.report.ResultPageWriter;
import particles.teaching.exercises.AnswersFile;
import particles.teaching.exercises.Exercises;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Exercise;
import particles.teaching.marking.Mark;
import particles.view.DataTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * {@code gradle grade -Pstudent=ID}: marks all answers and all solvers of a student, as one report and for autograders.
 */
@Command(name = GradeCommand.NAME, description = "Marks all answers and solvers of a student.")
public final class GradeCommand extends ProgramCommand {
    static final String NAME = "grade";

    @Option(names = "--student", paramLabel = "ID", required = true, description = "The student's id.")
    private String student;

    @Option(names = "--answers", paramLabel = "FILE", defaultValue = "answers.yaml",
            description = "The file of answers, lines such as 5: 3.42 (default: answers.yaml).")
    private Path answers;

    @Option(names = "--solvers", paramLabel = "NAMES",
            description = "Solver classes that have to pass, separated by commas"
            + " (default: every ...Solver.java in src/main/java/exercises).")
    private String solvers;

    @Option(names = "--out", paramLabel = "FOLDER", defaultValue = "build/out/grade",
            description = "Where the report goes (default: build/out/grade).")
    private Path results;

    private final Path folder;

    /**
     * @param folder the folder of the student's classes
     */
    public GradeCommand(Path folder) {
        this.folder = folder;
    }

    /** One graded item: its name, whether it was handed in, and its mark. */
    private record Graded(String name, boolean answered, Mark mark) {
        boolean isUndecided() {
            return mark.lines().stream().anyMatch(line -> line.contains("not decided on this machine"));
        }

        void print(PrintWriter out) {
            out.println((!answered ? "missing   " : mark.right() ? "mark      " : isUndecided() ? "undecided "
                    : "no mark   ") + name);
            if (answered) {
                mark.lines().forEach(line -> out.println("            " + line));
            }
        }
    }

    @Override
    public void run(PrintWriter out) throws IOException {
        if (student.isBlank()) {
            throw wrong("student", "the id is empty");
        }
        try (OutputFolder files = OutputFolder.open(results, NAME + ".md", "marks.csv", "TEST-" + NAME + ".xml")) {
            AnswersFile read = AnswersFile.read(answers);
            read.problems().forEach(out::println);
            List<Graded> graded = new ArrayList<>(exercises(read));
            graded.addAll(solvers());
            graded.forEach(item -> item.print(out));
            long marks = graded.stream().filter(item -> item.mark().right()).count();
            String title = marks + " of " + graded.size() + " marks for " + student.strip();
            write(files, title, read.problems(), graded);
            out.println(title + "; report: " + results.resolve(NAME + ".md"));
            if (marks < graded.size()) {
                throw new Failure(ExitCode.BAD_INPUT, graded.size() - marks == 1 ? "one mark is missing"
                        : graded.size() - marks + " marks are missing");
            }
        }
    }

    private List<Graded> exercises(AnswersFile read) {
        List<Graded> graded = new ArrayList<>();
        for (int number = 1; number <= Exercises.all().size(); number++) {
            Exercise exercise = Exercises.all().get(number - 1);
            String answer = read.answers().get(number);
            graded.add(new Graded(number + ". " + exercise.title(), answer != null,
                    answer == null      // null for a number without an answer
                    ? new Mark(false, List.of("There is no answer."))
                    : mark(exercise, number, answer)));
        }
        return graded;
    }

    /** A scene's path is relative to the folder of the answers, which it cannot leave; both are handed in together. */
    private Mark mark(Exercise exercise, int number, String answer) {
        Draw draw = new Draw(student, number);
        if (number < Exercises.all().size() || answer.isBlank()) {
            return exercise.mark(draw, answer);
        }
        try {
            Path folder = answers.toAbsolutePath().normalize().getParent();
            Path scene = folder.resolve(answer.strip()).normalize();
            if (!scene.startsWith(folder) || Files.exists(scene)
                    && !scene.toRealPath().equals(folder.toRealPath().resolve(folder.relativize(scene)))) {
                return Mark.wrong("'" + answer.strip() + "' is outside of the folder of " + answers.getFileName()
                        + ", or a link: hand the scene's file in beside it.");
            }
            return exercise.mark(draw, answers.resolveSibling(answer.strip()).toString());
        } catch (IOException | InvalidPathException e) {
            return Mark.wrong("'" + answer.strip() + "' cannot be read: " + e.getMessage());
        }
    }

    private List<Graded> solvers() throws IOException {
        Map<String, String> sources = StudentLoader.sources(folder);
        Set<String> names = new LinkedHashSet<>();
        if (solvers != null) {                          // picocli leaves an option null that was not given
            Stream.of(solvers.split(",")).map(name -> name.strip().replaceFirst("^exercises[.]", ""))
                    .filter(name -> !name.isEmpty()).forEach(names::add);
        } else {
            sources.keySet().stream().filter(name -> name.endsWith("Solver")).forEach(names::add);
        }
        List<Graded> graded = new ArrayList<>();
        for (String name : names) {
            graded.add(new Graded("solver " + name, true, check(name, sources)));
        }
        return graded;
    }

    private Mark check(String name, Map<String, String> sources) throws IOException {
        if (!sources.containsKey(name)) {
            return new Mark(false, List.of("there is no file " + name + ".java"));
        }
        StudentProcess.Outcome outcome;
        try {
            outcome = StudentProcess.run(List.of(CheckSolverCommand.NAME, "--solver=exercises." + name,
                    "--out=" + results.resolve(name)), sources);
        } catch (Failure stopped) {
            return new Mark(false, stopped.getLines());
        }
        return new Mark(outcome.code() == ExitCode.DONE, outcome.lines());
    }

    /** Joins lines for a table's cell; sentences and headings stay on lines of their own. */
    private static String paragraph(List<String> lines) {
        StringBuilder text = new StringBuilder();
        for (String line : lines) {
            text.append(text.length() == 0 ? "" : text.toString().matches("(?s).*[.:]") ? " "
                    : "; ").append(line.strip());
        }
        return text.toString();
    }

    private static void write(OutputFolder files, String title, List<String> problems, List<Graded> graded) {
        List<List<Object>> rows = new ArrayList<>();
        List<JUnitXml.Case> cases = new ArrayList<>();
        for (Graded item : graded) {
            String first = item.mark().lines().isEmpty() ? "" : item.mark().lines().get(0);
            rows.add(List.of(item.name(), item.mark().right() ? 1 : 0, paragraph(item.mark().lines())));
            cases.add(new JUnitXml.Case(item.name(), item.mark().right() ? Optional.empty() : Optional.of(first),
                    item.mark().lines()));
        }
        DataTable table = new DataTable("marks", "Marks",
                List.of(DataTable.column("exercise"), DataTable.column("mark"),
                DataTable.column("what there is to say")), rows);
        ResultPageWriter.write(files, new ResultPage(NAME, title, problems, List.of(), List.of(table)),
                ChartFormat.PAGE);
        JUnitXml.write(files, NAME, cases);
    }
}
