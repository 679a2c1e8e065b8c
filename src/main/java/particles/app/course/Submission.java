package particles.app.course;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import org.apache.commons.compress.archivers.tar.TarArchiveEntry;
import org.apache.commons.compress.archivers.tar.TarArchiveInputStream;
import particles.spec.SourceText;
import particles.spec.messages.InvalidInputException;

/**
 * A hand-in as Moodle and GitHub Classroom download it: a folder, a zip or .tar.gz, a folder with these, or the files
 * of Moodle's download without folders. It is read into memory before any class runs. Links are not followed, and
 * archives inside archives are not opened.
 *
 * @param name    the name of the folder or archive
 * @param files   the texts of the YAML and Java files, by their paths
 * @param damaged the files that cannot be read, and why, a line each
 * @param others  the paths of all other files
 * @param dates   the dates of the texts
 */
record Submission(String name, Map<String, String> files, List<String> damaged, List<String> others,
        List<FileTime> dates) {
    /** Moodle's names of folders, and of files in a download without folders: student, number, file. */
    static final Pattern MOODLE = Pattern.compile("(.*)_(\\d+)_assignsubmission_[a-z]+_?(.*)");
    static final String ANSWERS = "answers.yaml";
    private static final int LARGEST = 1 << 20;
    private static final Pattern ARCHIVE = Pattern.compile("(?i)(.*)[.](zip|tar[.]gz|tgz|rar|7z|tar)");
    /** A file among hand-ins; its name begins with that of the hand-in. */
    private static final Pattern FILE = Pattern.compile("(.*_assignsubmission_[a-z]+_).*|" + ARCHIVE.pattern());
    private static final Pattern TEXT = Pattern.compile("(?i)(.*[.](?:java|ya?ml)|(?:.*/)?answers?)(?:[.]txt)?");
    private static final Pattern ANY_ANSWERS = Pattern.compile("(?i)(.*/)?answers?\\W*\\d*\\W*([.]ya?ml)?");
    private static final Comparator<String> DEPTH = Comparator.comparingLong(path ->
            path.chars().filter(c -> c == '/').count());
    /** What is not the student's: hidden files, what a Mac adds to a zip, what is built, and this project. */
    private static final Pattern NOT_HANDED_IN = Pattern.compile(
            "(?:^|/)(?:[.][^/]+|__MACOSX|build|src/test|src/main/java/(?:particles|deSolvers))(?:/|$)");
    private static final Pattern OTHER_PACKAGE = Pattern.compile("(?m)^\\s*package\\s+(?!exercises\\s*;)");

    /** An empty hand-in. */
    Submission(String name) {
        this(name, new TreeMap<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
    }

    /**
     * @param folder what was downloaded
     * @return the paths of each hand-in, by the name of the folder or archive, or how Moodle's names of its files begin
     * @throws IOException           if the folder cannot be read
     * @throws InvalidInputException if Java cannot write a name in this locale
     */
    static Map<String, List<Path>> list(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(path -> !NOT_HANDED_IN.matcher(nameOf(path)).find() && (isFolder(path) || FILE.matcher(
                    nameOf(path)).matches())).sorted().collect(Collectors
                    .groupingBy(path -> isFolder(path) ? nameOf(path) : FILE.matcher(nameOf(path)).replaceFirst("$1$2"),
                    TreeMap::new, Collectors.toList()));
        }
    }

    private static String nameOf(Path path) {
        String name = path.getFileName().toString();
        try {
            return Path.of(name).toString();
        } catch (InvalidPathException e) {              // where the locale is C, only ASCII can be in a name
            throw new InvalidInputException(name + ": Java cannot write this name; set LC_ALL=C.UTF-8");
        }
    }

    private static boolean isFolder(Path path) {
        return Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS);
    }

    /** @return the number that Moodle gave the participant; otherwise the name */
    static String id(String name) {
        Matcher moodle = MOODLE.matcher(name);
        return moodle.matches() ? moodle.group(2) : name;
    }

    /** @return what is in the paths of a hand-in, by its name in the {@link #list} */
    static Submission read(String name, List<Path> paths) {
        Submission read = new Submission(name);
        for (Path path : paths) {
            try {
                if (isFolder(path)) {
                    read.addAll(path);
                } else {
                    read.add(nameOf(path).replaceFirst(".*_assignsubmission_[a-z]+_(?=[^.])", ""), path);
                }
            } catch (IOException | RuntimeException e) {
                read.damaged.add(nameOf(path) + ": " + e.getMessage());
            }
        }
        return read;
    }

    private void addAll(Path folder) throws IOException {
        try (Stream<Path> walk = Files.walk(folder)) {
            for (Path file : walk.filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)).sorted()
                    .toList()) {
                add(folder.relativize(file).toString().replace('\\', '/'), file);
            }
        }
    }

    private void add(String place, Path file) {
        Matcher archive = ARCHIVE.matcher(place);
        try (InputStream bytes = Files.newInputStream(file)) {
            if (!archive.matches() || NOT_HANDED_IN.matcher(place).find()) {
                add(place, bytes, Files.getLastModifiedTime(file));
            } else if (archive.group(2).equalsIgnoreCase("zip")) {
                zip(file);
            } else if (archive.group(2).matches("(?i).*gz")) {
                tar(bytes);
            } else {
                throw new IOException("only .zip and .tar.gz are read");
            }
        } catch (IOException | RuntimeException e) {
            damaged.add(place + ": " + e.getMessage());
        }
    }

    /** Names are in UTF-8, or in the code page of old Windows programs. */
    private static ZipFile opened(File file) throws IOException {
        try {
            return new ZipFile(file);
        } catch (ZipException e) {
            return new ZipFile(file, Charset.forName("IBM437"));
        }
    }

    private void zip(Path file) throws IOException {
        try (ZipFile zip = opened(file.toFile())) {
            for (ZipEntry entry : zip.stream().filter(entry -> !entry.isDirectory()).toList()) {
                try (InputStream bytes = zip.getInputStream(entry)) {
                    byte[] start = bytes.readNBytes(LARGEST);
                    CRC32 sum = new CRC32();            // ZipFile does not check it
                    sum.update(start);
                    if (start.length < LARGEST && sum.getValue() != entry.getCrc()) {
                        throw new IOException("it is damaged");
                    }
                    add(entry.getName(), new ByteArrayInputStream(start), entry.getLastModifiedTime());
                } catch (IOException e) {
                    damaged.add(entry.getName() + ": " + e.getMessage());
                }
            }
        }
    }

    private void tar(InputStream bytes) throws IOException {
        try (TarArchiveInputStream tar = new TarArchiveInputStream(new GZIPInputStream(bytes), "UTF-8")) {
            for (TarArchiveEntry entry = tar.getNextEntry(); entry != null; entry = tar.getNextEntry()) {
                if (entry.isFile()) {
                    add(entry.getName(), tar, entry.getLastModifiedTime());
                }
            }
        }
    }

    private void add(String place, InputStream bytes, FileTime date) throws IOException {
        Matcher text = TEXT.matcher(place);
        if (text.matches() && !NOT_HANDED_IN.matcher(place).find()) {
            files.put(text.group(1), SourceText.lenient(bytes.readNBytes(LARGEST)));
            dates.add(date);
        } else {
            others.add(place);
        }
    }

    /** @return the name of the folder of its result, in which Moodle knows feedback */
    String folder() {
        return name + (name.endsWith("_assignsubmission_file") ? "_" : "");
    }

    /** @return the latest date of a file, to the second; empty if there is no file */
    String newest() {
        return dates.stream().max(Comparator.naturalOrder()).map(date -> date.toString().replaceFirst("[.]\\d+", ""))
                .orElse("");
    }

    /** @return the paths of all that may be answers; first what is fewest folders deep and called as it should be */
    List<String> answers() {
        return files.keySet().stream().filter(ANY_ANSWERS.asMatchPredicate()).sorted(DEPTH.thenComparing(path ->
                !path.endsWith(ANSWERS))).toList();         // keys are sorted already
    }

    /** @return the files that a student may have meant to count, and that do not, a line each */
    List<String> remarks() {
        return Stream.concat(answers().stream().skip(1), others.stream().filter(path -> files.isEmpty() || path.matches(
                "(?i)(.*/)?answers?[.].*")).limit(2)).map(path -> path + " is not read"
                + answers().stream().limit(1).map(best -> ": the answers are in " + best).collect(Collectors.joining()))
                .toList();
    }

    /**
     * @return the text of each class in a folder exercises; without one, of each class of no other package; of several
     *         with one name, the one that is fewest folders deep
     */
    Map<String, String> sources() {
        List<String> classes = files.keySet().stream().filter(path -> path.matches("(?i).*[.]java")).sorted(DEPTH)
                .toList();
        List<String> named = classes.stream().filter(path -> ("/" + path).contains("/exercises/")).toList();
        return (named.isEmpty() ? classes.stream().filter(path -> !OTHER_PACKAGE.matcher(files.get(path)).find())
                : named.stream()).collect(Collectors.toMap(path -> path.replaceAll(".*/|[.]\\w+$", ""), path ->
                files.get(path), (first, deeper) -> first, TreeMap::new));
    }

    /**
     * @param path a path, as an answer names it: from the folder of the answers
     * @return the contents of this file
     * @throws InvalidInputException if it was not handed in
     */
    byte[] file(String path) {
        String wanted = ClassList.fold(answers().get(0).replaceFirst("[^/]*$", "") + path.replace('\\', '/')
                .replaceFirst("^([.]/)+", ""));
        return files.keySet().stream().filter(file -> ClassList.fold(file).equals(wanted)).findFirst().map(file ->
                files.get(file).getBytes(StandardCharsets.UTF_8)).orElseThrow(() -> new InvalidInputException(path
                + ": there is no such file in the hand-in"));
    }
}
