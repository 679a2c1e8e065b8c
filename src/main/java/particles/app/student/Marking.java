package particles.app.student;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.JUnitXml;
import particles.output.report.ResultPage;
import particles.output.report.ResultPageWriter;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import particles.teaching.exercises.AnswersFile;
import particles.teaching.exercises.Exercises;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Exercise;
import particles.teaching.marking.Mark;
import particles.view.DataTable;

/**
 * The marking of one student's hand-in, by {@code grade} and by {@code gradeClass}.
 *
 * @param student the student's id
 * @param answers the file of answers
 * @param sources the text of each class that was handed in
 * @param reports the folder of the reports on the classes
 */
record Marking(String student, Path answers, Map<String, String> sources, Path reports) {
    static final String PAGE = "grade";
    private static final double SECONDS = 60;

    /** One graded item: its name, whether it was handed in, and its mark. */
    record Graded(String name, boolean answered, Mark mark) {
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

    /** @return the marks of the answers; runs no class of the student */
    List<Graded> exercises(AnswersFile read) {
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
            Outcome<Mark> marked = new GuardedRun(SECONDS).run(() -> exercise.mark(draw,
                    answers.resolveSibling(answer.strip()).toString()));
            return marked.value().orElseGet(() -> Mark.wrong(marked.failure().orElseThrow().text()));
        } catch (IOException | InvalidPathException e) {
            return Mark.wrong("'" + answer.strip() + "' cannot be read: " + e.getMessage());
        }
    }

    /**
     * @param wanted the classes that have to pass
     * @return the mark of each
     * @throws IOException if no process can be made
     */
    List<Graded> classes(WantedClasses wanted) throws IOException {
        List<Graded> graded = new ArrayList<>();
        for (String name : wanted.solvers(sources.keySet())) {
            graded.add(check("solver", name, CheckSolverCommand.NAME));
        }
        for (String name : wanted.effects()) {
            graded.add(check("effect", name, CheckEffectCommand.NAME));
        }
        return graded;
    }

    private Graded check(String kind, String name, String command) throws IOException {
        Mark mark;
        if (!sources.containsKey(name)) {
            mark = Mark.wrong("there is no file " + name + ".java");
        } else {
            try {
                StudentProcess.Outcome outcome = StudentProcess.run(List.of(command, "--" + kind + "=exercises." + name,
                        "--out=" + reports.resolve(name)), sources);
                mark = new Mark(outcome.code() == ExitCode.DONE, outcome.lines());
            } catch (Failure stopped) {
                mark = new Mark(false, stopped.getLines());
            }
        }
        return new Graded(kind + " " + name, true, mark);
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

    /**
     * Writes the student's page, grade.md, marks.csv and TEST-grade.xml.
     *
     * @return how many marks there are, in words
     */
    String write(OutputFolder files, List<String> problems, List<Graded> graded) {
        String title = graded.stream().filter(item -> item.mark().right()).count() + " of " + graded.size()
                + " marks for " + student.strip();
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
        ResultPageWriter.write(files, new ResultPage(PAGE, title, problems, List.of(), List.of(table)),
                ChartFormat.PAGE);
        JUnitXml.write(files, PAGE, cases);
        return title;
    }
}
