package particles.app.course;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.app.cli.PrintedProgress;
import particles.app.cli.ResultsCommand;
import particles.app.course.Result.Status;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.frames.Pipeline;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle gradeClass -Pfolder=submissions}: marks every hand-in of a class, each as {@code grade} does. */
@Command(name = GradeClassCommand.NAME, description = "Marks the hand-ins of a class.")
public final class GradeClassCommand extends ResultsCommand {
    static final String NAME = "gradeClass";

    /** Where the results come from. */
    static final class Source {
        @Option(names = "--folder", paramLabel = "FOLDER",
                description = "The hand-ins, as Moodle and GitHub Classroom download them.")
        private Optional<Path> folder;

        @Option(names = "--collect", paramLabel = "FOLDER",
                description = "In place of --folder: the folder with the results of all parts of a class.")
        private Optional<Path> collect;
    }

    @ArgGroup(multiplicity = "1")
    private Source source;

    @Option(names = "--students", paramLabel = "FILE", description = "A CSV file: a list from Moodle, or lines with an"
            + " id, a name, and other names used in the hand-ins.")
    private Optional<Path> students;

    @Option(names = "--part", paramLabel = "K/N", split = "/",
            description = "Marks only part K of N, such as 3/16; --collect then makes the tables.")
    private List<Integer> part = List.of(1, 1);

    @Mixin
    private final CourseOptions course = new CourseOptions();

    @Override
    protected void read(Mistakes mistakes) {
        super.read(mistakes);
        mistakes.check(() -> {
            source.folder.or(() -> source.collect).filter(path -> !Files.isDirectory(path)).ifPresent(path -> {
                throw wrong("folder", "'" + path + "' is not a folder");
            });
            if (part.size() != 2 || part.get(0) < 1 || part.get(0) > part.get(1)) {
                throw wrong("part", "has to be a part of a class, such as 3/16");
            }
            if (part.get(1) > 1 && source.folder.isEmpty()) {
                throw wrong("part", "is for marking; all parts are collected together");
            }
        });
    }

    @Override
    public void run(PrintWriter out) throws Exception {
        Assignment assignment = course.readAssignment();
        if (assignment.numbers() == Assignment.Numbers.SHEET && course.getKey().isEmpty()
                && source.folder.isPresent()) {
            throw wrong("key", "is needed: by the assignment, the numbers are those of the handouts");
        }
        ClassList list = students.map(ClassList::read).orElse(ClassList.NONE);
        list.remarks().forEach(out::println);
        if (part.get(1) > 1) {
            out.println(marked(list, assignment, out).size() + " hand-ins are marked in " + getFolder()
                    + "; make the tables with " + getStyle().option("collect"));
            return;
        }
        try (OutputFolder files = OutputFolder.open(getFolder())) {
            List<Result> results = new ArrayList<>(source.folder.isPresent() ? marked(list, assignment, out)
                    : collected(assignment, list));
            Set<String> there = results.stream().map(result -> ClassList.fold(result.student())).collect(Collectors
                    .toSet());
            Submission nothing = new Submission("");
            Marking unmarked = new Marking(assignment, Optional.empty(), nothing, getFolder());
            list.students().entrySet().stream().filter(each -> !there.contains(each.getKey())).map(each ->
                    unmarked.result(Optional.of(each.getValue().id()))).forEach(results::add);
            new ClassTables(list, results).write(files).forEach(out::println);
        }
    }

    @Override
    public String whenStopped() {
        return name() + " was stopped; the same command goes on with those who are not marked yet";
    }

    /** Finds the results in a folder; a damaged one is a student's whose marks cannot be read. */
    private List<Result> collected(Assignment assignment, ClassList list) throws IOException {
        try (Stream<Path> all = Files.walk(source.collect.orElseThrow())) {
            return all.filter(file -> file.endsWith(Result.FILE)).sorted().map(file -> Result.read(file).orElseGet(
                    () -> {
                        Submission handIn = new Submission(file.getParent().getFileName().toString());
                        handIn.damaged().add(file + " is damaged");
                        return new Marking(assignment, Optional.empty(), handIn, file).result(list.id(handIn.name()));
                    })).toList();
        }
    }

    /**
     * Reads all hand-ins of this part, and only then marks them, one on each core. A hand-in that has not changed since
     * it was marked keeps its result.
     */
    private Collection<Result> marked(ClassList list, Assignment assignment, PrintWriter out) throws IOException {
        Function<String, Optional<String>> numbers = course.numbersOf(assignment);
        List<Map.Entry<String, List<Path>>> all = List.copyOf(Submission.list(source.folder.orElseThrow()).entrySet());
        List<Submission> handIns = IntStream.range(0, all.size()).filter(k -> k % part.get(1) == part.get(0) - 1)
                .mapToObj(all::get).map(each -> Submission.read(each.getKey(), each.getValue())).toList();
        PrintedProgress progress = new PrintedProgress(out, System::nanoTime);
        Map<Path, Result> results = new LinkedHashMap<>();
        try (Pipeline<Path> cores = new Pipeline<>(Runtime.getRuntime().availableProcessors(), this::getFolder)) {
            handIns.forEach(handIn -> cores.add(folder -> {
                Path where = folder.resolve(handIn.folder());
                Optional<String> owner = list.id(handIn.name());
                Marking marking = new Marking(assignment, owner.flatMap(numbers), handIn, where);
                Result result = Result.read(where.resolve(Result.FILE)).filter(earlier -> earlier.student().equals(
                        owner.orElse("")) && earlier.digest().equals(marking.digest()) && earlier.status()
                        != Status.ERROR).orElseGet(() -> marking.result(owner));
                write(where, result, out);              // at once, so that it counts after a stop
                return () -> {
                    results.put(where, result);
                    progress.reached((double) results.size() / handIns.size(), result.student());
                };
            }));
        }
        // once more: a class may have changed what was written
        results.forEach((where, result) -> write(where, result, out));
        return results.values();
    }

    private static void write(Path where, Result result, PrintWriter out) {
        try {
            Marking.write(where, result);
        } catch (OutputException e) {
            out.println("the page of " + result.student() + " is missing: " + e.getMessage());
        }
    }
}
