package particles.app.student;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.PrintedProgress;
import particles.app.cli.ResultsCommand;
import particles.app.cli.Version;
import particles.app.student.Marking.Graded;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.Report;
import particles.output.report.ReportWriter;
import particles.output.report.ResultPage;
import particles.output.report.ResultPageWriter;
import particles.teaching.exercises.AnswersFile;
import particles.teaching.marking.Mark;
import particles.view.DataTable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle gradeClass -Pfolder=submissions}: marks every hand-in of a class, each as {@code grade} does. */
@Command(name = GradeClassCommand.NAME, description = "Marks the hand-ins of a class.")
public final class GradeClassCommand extends ResultsCommand {
    static final String NAME = "gradeClass";
    private static final int MOST_COMMON = 10;

    @Option(names = "--folder", paramLabel = "FOLDER", required = true,
            description = "A folder or zip for each student, as Moodle and GitHub Classroom download them.")
    private Path folder;

    @Option(names = "--students", paramLabel = "FILE",
            description = "A CSV file with a header; each line has an id first, then names used in the hand-ins.")
    private Path students;

    @Mixin
    private final WantedClasses wanted = new WantedClasses();

    /** A student's hand-in while it is marked; it has no submission if there is none. */
    private record Entry(String student, Optional<Submission> submission, Marking marking, List<String> problems,
                         List<Graded> graded) {
        long points() {
            return graded.stream().filter(item -> item.mark().right()).count();
        }
    }

    /** A mark of a student. */
    private record Row(Entry entry, Graded item) {
        String mistake() {
            List<String> lines = item.mark().lines();
            return item.mark().right() || lines.isEmpty() ? "" : lines.stream()
                    .filter(line -> line.matches("(WRONG|PROMISE), .*")).findFirst().orElse(lines.get(0));
        }
    }

    @Override
    public void run(PrintWriter out) throws Exception {
        List<Path> paths;
        try (Stream<Path> all = Files.list(folder)) {
            paths = all.filter(path -> Files.isDirectory(path) || path.toString().toLowerCase(Locale.ROOT)
                    .endsWith(".zip")).sorted().toList();
        } catch (IOException e) {
            throw wrong("folder", "'" + folder + "' is not a folder that can be read");
        }
        Path copies = Files.createTempDirectory("desolver-class");
        try (OutputFolder files = OutputFolder.open(getFolder(), "class.md", "class.csv", "class.html")) {
            List<Entry> entries = new ArrayList<>();
            List<String> problems = new ArrayList<>();
            for (Map.Entry<String, Optional<Submission>> found : found(paths, problems).entrySet()) {
                entries.add(entry(found.getKey(), found.getValue(), copies.resolve("" + entries.size())));
            }
            entries.forEach(entry -> answers(entry));       // runs no class; only then do the classes run
            classes(entries, out);
            for (Entry entry : entries) {
                try (OutputFolder own = OutputFolder.open(entry.marking().reports(), Marking.PAGE + ".md")) {
                    entry.marking().write(own, entry.problems(), entry.graded());
                }
            }
            write(files, entries, problems);
            problems.forEach(out::println);
            out.println(entries.size() + " students; table: " + getFolder().resolve("class.html"));
        } finally {
            try (Stream<Path> made = Files.walk(copies)) {
                for (Path path : made.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(path);
                }
            }
        }
    }

    /** Finds each student's latest hand-in; with a list of students, also who handed nothing in. */
    private Map<String, Optional<Submission>> found(List<Path> paths, List<String> problems) throws IOException {
        Map<String, List<String>> words = new TreeMap<>();
        if (students != null) {                         // picocli leaves an option null that was not given
            for (String line : Files.readString(students).replaceFirst("^\ufeff", "").lines().skip(1).toList()) {
                List<String> cells = Stream.of(line.split("[,;]")).map(cell -> cell.strip().replaceAll("^\"|\"$", ""))
                        .toList();
                words.put(cells.get(0), cells);
            }
            words.remove("");
        }
        Map<String, Optional<Submission>> found = new TreeMap<>();
        words.keySet().forEach(id -> found.put(id, Optional.empty()));
        for (Path path : paths) {
            Submission read;
            try {
                read = Submission.read(path);
            } catch (IOException | RuntimeException e) {
                problems.add(path.getFileName() + " cannot be read: " + e.getMessage());
                continue;
            }
            List<String> ids = words.keySet().stream().filter(id -> words.get(id).stream().anyMatch(read::isOf))
                    .toList();
            if (ids.size() != 1 && !words.isEmpty()) {
                problems.add(read.name() + " belongs to " + (ids.isEmpty() ? "nobody" : "more than one") + " in "
                        + students.getFileName());
            }
            String id = ids.size() == 1 ? ids.get(0) : read.id();
            Submission last = found.getOrDefault(id, Optional.empty()).filter(other ->
                    other.newest().isAfter(read.newest())).orElse(read);
            found.put(id, Optional.of(last));
        }
        found.forEach((id, submission) -> {
            if (submission.isEmpty()) {
                problems.add("nothing was handed in by " + id);
            }
        });
        return found;
    }

    private Entry entry(String student, Optional<Submission> submission, Path copy) throws IOException {
        Files.createDirectories(copy);
        Path answers = submission.isPresent() ? submission.get().copyAnswers(copy) : copy.resolve("answers.yaml");
        return new Entry(student, submission, new Marking(student, answers, submission.map(Submission::sources)
                .orElse(Map.of()), getFolder().resolve(student.replaceAll("[^\\w-]", "_"))), new ArrayList<>(),
                new ArrayList<>());
    }

    /** Marks the answers; messages name files as the student handed them in, not the copies. */
    private static void answers(Entry entry) {
        String copy = entry.marking().answers().resolveSibling("").toString().replace('\\', '/') + "/";
        AnswersFile read = AnswersFile.read(entry.marking().answers());
        entry.problems().addAll(read.problems().stream().map(line -> line.replace(copy, "")).toList());
        entry.marking().exercises(read).forEach(item -> entry.graded().add(new Graded(item.name(), item.answered(),
                new Mark(item.mark().right(), item.mark().lines().stream().map(line -> line.replace(copy, ""))
                .toList()))));
    }

    private void classes(List<Entry> entries, PrintWriter out) throws InterruptedException, ExecutionException {
        ExecutorService workers = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            List<Future<List<Graded>>> marks = new ArrayList<>();
            for (Entry entry : entries) {
                marks.add(workers.submit(() -> entry.marking().classes(wanted)));
            }
            PrintedProgress progress = new PrintedProgress(out, System::nanoTime);
            for (int k = 0; k < entries.size(); k++) {
                entries.get(k).graded().addAll(marks.get(k).get());
                progress.reached((k + 1.0) / entries.size(), entries.get(k).student());
            }
        } finally {
            workers.shutdownNow();
        }
    }

    private void write(OutputFolder files, List<Entry> entries, List<String> problems) {
        List<Row> rows = entries.stream().flatMap(entry -> entry.graded().stream().map(item -> new Row(entry, item)))
                .toList();
        DataTable all = DataTable.of("class", "All marks", rows,
                DataTable.column("student", row -> row.entry().student()),
                DataTable.column("exercise", row -> row.item().name()),
                DataTable.column("points", row -> row.item().mark().right() ? 1 : 0),
                DataTable.column("mistake", Row::mistake),
                DataTable.column("handed in", row -> row.entry().submission().map(found -> found.newest()
                .truncatedTo(ChronoUnit.SECONDS).toString()).orElse("")),
                DataTable.column("version", row -> Version.CURRENT));
        DataTable each = DataTable.of("students", "Students", entries,
                DataTable.column("student", Entry::student), DataTable.column("points", Entry::points),
                DataTable.column("of", entry -> entry.graded().size()),
                DataTable.column("handed in as", entry -> entry.submission().map(Submission::name).orElse("nothing")));
        Map<String, Long> counts = rows.stream().filter(row -> row.item().answered() && !row.mistake().isEmpty())
                .map(row -> row.item().name() + ": " + row.mistake())
                .collect(Collectors.groupingBy(Function.identity(), TreeMap::new, Collectors.counting()));
        DataTable common = DataTable.of("mistakes", "The commonest mistakes", counts.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed()).limit(MOST_COMMON).toList(),
                DataTable.column("students", Map.Entry::getValue), DataTable.column("mistake", Map.Entry::getKey));
        List<String> text = new ArrayList<>(problems);
        Map<String, Map<String, String>> sources = new TreeMap<>();
        entries.forEach(entry -> sources.put(entry.student(), entry.marking().sources()));
        List<String> look = Copies.toLookAt(sources);
        text.add((look.isEmpty() ? "No classes are alike, and none uses a solver of the project."
                : "Please look at these classes; nobody lost a mark for it.") + " JPlag compares more closely.");
        text.addAll(look);
        ResultPage page = new ResultPage("class", entries.stream().mapToLong(Entry::points).sum() + " marks for "
                + entries.size() + " students", text, List.of(), List.of(each, common, all));
        ResultPageWriter.write(files, page, ChartFormat.PAGE);
        ReportWriter.write(files, "class.html", new Report(page.title(), List.of(), List.of(new Report.Section(NAME,
                "marks the hand-ins of a class", getFolder(), 0, Optional.of(page), Optional.empty())),
                "version " + Version.CURRENT));
    }
}
