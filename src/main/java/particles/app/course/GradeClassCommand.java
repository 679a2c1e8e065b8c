package particles.app.course;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.app.cli.PrintedProgress;
import particles.app.cli.ResultsCommand;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.files.TemporaryFolder;
import particles.output.frames.Pipeline;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle gradeClass -Pfolder=submissions}: marks every hand-in of a class, each as {@code grade} does. */
@Command(name = GradeClassCommand.NAME, description = "Marks the hand-ins of a class.")
public final class GradeClassCommand extends ResultsCommand {
    static final String NAME = "gradeClass";
    private static final String BEST = "best";

    @Option(names = "--folder", paramLabel = "FOLDER",
            description = "A folder or zip for each student, as Moodle and GitHub Classroom download them.")
    private Path folder;

    @Option(names = "--collect", paramLabel = "FOLDER",
            description = "In place of --folder: the results of grade, each in a folder of its own.")
    private Path collect;

    @Option(names = "--students", paramLabel = "FILE",
            description = "A CSV file with a header; each line has an id first, then names used in the hand-ins.")
    private Path students;

    @Option(names = "--attempt", paramLabel = "WHICH",
            description = "Which of several hand-ins counts: last or best (default: last).")
    private String attempt = "last";

    @Mixin
    private final CourseOptions course = new CourseOptions();

    private final List<String> problems = new ArrayList<>();
    private final Map<Path, String> digests = new TreeMap<>();

    @Override
    public void run(PrintWriter out) throws Exception {
        if (!attempt.equals("last") && !attempt.equals(BEST)) {
            throw wrong("attempt", "'" + attempt + "' has to be last or best");
        }
        if ((folder == null) == (collect == null)) {    // null where it was not given
            throw wrong("folder", "give either this option or " + getStyle().option("collect"));
        }
        Assignment assignment = course.assignment();
        if (assignment.sheets() && course.key().isEmpty() && collect == null) {
            throw wrong("key", "is needed: by the assignment, the numbers are those of the handouts");
        }
        try (TemporaryFolder temporary = new TemporaryFolder("desolver-class");
                OutputFolder files = OutputFolder.open(getFolder(), ClassTables.FILES.toArray(new String[0]))) {
            Path copies = temporary.getPath();
            Map<String, List<String>> words = students == null ? Map.of() : CourseOptions.read(students);
            List<Result> results = new ArrayList<>();
            if (collect == null) {
                results.addAll(marked(found(words), assignment, copies, out));
            } else {
                inside(collect, "collect").stream().map(each -> each.resolve(Result.FILE)).filter(Files::isRegularFile)
                        .map(Result::read).forEach(results::add);
            }
            for (String id : words.keySet()) {
                if (results.stream().noneMatch(result -> result.student().equalsIgnoreCase(id))) {
                    problems.add("nothing was handed in by " + id);
                    results.add(Marking.begin(id, Submission.NONE, assignment, List.of(), copies,
                            copies.resolve("none")).get());
                }
            }
            Marking.clear(getFolder(), ClassTables.FILES);
            String said = new ClassTables(assignment, results, attempt.equals(BEST)).write(files, getFolder(),
                    problems);
            problems.forEach(out::println);
            out.println(said);
        }
    }

    @Override
    public String whenStopped() {
        return name() + " was stopped; the same command goes on with those who are not marked yet";
    }

    private List<Path> inside(Path given, String option) {
        try (Stream<Path> all = Files.list(given)) {
            return all.sorted().toList();
        } catch (IOException e) {
            throw wrong(option, "'" + given + "' is not a folder that can be read");
        }
    }

    /** Finds each student's hand-ins, the last one first. */
    private Map<String, List<Submission>> found(Map<String, List<String>> words) {
        Map<String, List<Submission>> found = new TreeMap<>();
        for (Path path : inside(folder, "folder")) {
            if (!Files.isDirectory(path) && !Submission.isZip(path)) {
                continue;
            }
            Submission read;
            try {
                read = Submission.read(path);
            } catch (IOException | RuntimeException e) {
                problems.add(path.getFileName() + " cannot be read: " + e.getMessage());
                continue;
            }
            digests.put(path, read.digest());
            // of ann and mary-ann, hw1-mary-ann belongs to the longer one
            int longest = words.values().stream().mapToInt(read::longestOf).max().orElse(0);
            List<String> ids = words.keySet().stream().filter(id -> longest > 0
                    && read.longestOf(words.get(id)) == longest).toList();
            if (ids.size() != 1 && !words.isEmpty()) {
                problems.add(read.name() + " belongs to " + (ids.isEmpty() ? "nobody" : "more than one") + " in "
                        + students.getFileName());
            }
            found.computeIfAbsent(ids.size() == 1 ? ids.get(0) : read.id(), id -> new ArrayList<>()).add(read);
        }
        found.values().forEach(all -> all.sort(Comparator.comparing(Submission::newest).reversed()));
        return found;
    }

    /** Marks all answers, which runs no class, and only then all classes, one hand-in on each core. */
    private List<Result> marked(Map<String, List<Submission>> found, Assignment assignment, Path copies,
            PrintWriter out) throws IOException {
        Map<Path, Supplier<Result>> begun = new LinkedHashMap<>();
        for (Map.Entry<String, List<Submission>> each : found.entrySet()) {
            List<String> numbers = course.numbers(assignment, each.getKey());
            if (numbers.isEmpty()) {
                problems.add(each.getKey() + " is not in the key file");
            }
            for (Submission handIn : each.getValue().subList(0, attempt.equals(BEST) ? each.getValue().size() : 1)) {
                Path results = folderOf(each.getKey(), begun.keySet());
                begun.put(results, Marking.begin(each.getKey(), handIn, assignment, numbers, results,
                        copies.resolve("" + begun.size())));
            }
        }
        PrintedProgress progress = new PrintedProgress(out, System::nanoTime);
        Map<Path, Result> results = new LinkedHashMap<>();
        try (Pipeline<Path> cores = new Pipeline<>(Runtime.getRuntime().availableProcessors(), this::getFolder)) {
            begun.forEach((where, marking) -> cores.add(folder -> {
                Result result = marking.get();
                write(where, result);                   // at once, so that it counts after a stop
                return () -> {
                    results.put(where, result);
                    progress.reached((double) results.size() / begun.size(), result.student());
                };
            }));
        }
        // once more: a class may have changed what was written
        results.forEach((where, result) -> write(where, result).ifPresent(problems::add));
        List<Path> changed = digests.keySet().stream().filter(this::isChanged).map(Path::getFileName).toList();
        if (!changed.isEmpty()) {
            problems.add(changed.get(0) + (changed.size() == 1 ? "" : " and " + (changed.size() - 1) + " more")
                    + " changed while classes ran; marked as before, but download again what is in " + folder);
        }
        return new ArrayList<>(results.values());
    }

    private boolean isChanged(Path handIn) {
        try {
            return !Submission.read(handIn).digest().equals(digests.get(handIn));
        } catch (IOException | RuntimeException gone) {
            return true;
        }
    }

    /** @return what went wrong, in a line */
    private static Optional<String> write(Path where, Result result) {
        try {
            Marking.write(where, result);
            return Optional.empty();
        } catch (OutputException e) {
            return Optional.of("the page of " + result.student() + " is missing: " + e.getMessage());
        }
    }

    private Path folderOf(String student, Set<Path> taken) {
        Path plain = getFolder().resolve(student.replaceAll("[^\\w-]", "_"));
        Path free = plain;
        for (int k = 2; taken.contains(free); k++) {
            free = plain.resolveSibling(plain.getFileName() + "." + k);
        }
        return free;
    }
}
