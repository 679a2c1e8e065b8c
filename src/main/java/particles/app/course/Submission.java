package particles.app.course;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import particles.spec.Digest;

/**
 * A hand-in as Moodle and GitHub Classroom download it: a folder or a zip, or a folder with a zip. It is copied before
 * any class runs. Links are not followed.
 *
 * @param name    the name of the folder or zip
 * @param files   the text of each YAML and Java file, by its path
 * @param newest  the latest date of one of these files
 */
record Submission(String name, Map<String, byte[]> files, Instant newest) {
    /** Nothing was handed in. */
    static final Submission NONE = new Submission("", Map.of(), Instant.EPOCH);
    private static final int MOST_FILES = 1000;
    private static final int LARGEST = 1 << 20;
    private static final String ANSWERS = "answers.yaml";
    private static final Comparator<String> DEPTH = Comparator.comparingLong(path ->
            path.chars().filter(c -> c == '/').count());
    private static final Pattern MOODLE = Pattern.compile("(.*)_(\\d+)_assignsubmission_file.*");
    /** What is not the student's: hidden files, what a Mac adds to a zip, and this project. */
    private static final Pattern NOT_HANDED_IN = Pattern.compile(
            "(?:^|/)(?:[.][^/]+|__MACOSX|src/test|src/main/java/(?:particles|deSolvers))(?:/|$)");
    private static final Pattern OTHER_PACKAGE = Pattern.compile("(?m)^\\s*package\\s+(?!exercises\\s*;)");

    /**
     * @param path a folder or a zip
     * @return what is in it
     * @throws IOException if it cannot be read
     */
    static Submission read(Path path) throws IOException {
        Submission found = new Submission(path.getFileName().toString().replaceFirst("(?i)[.]zip$", ""),
                new TreeMap<>(), Instant.EPOCH);
        return isZip(path) ? found.withZip(path) : found.with(path, true);
    }

    static boolean isZip(Path path) {
        return path.toString().toLowerCase(Locale.ROOT).endsWith(".zip");
    }

    private Submission withZip(Path zip) throws IOException {
        try (FileSystem inside = FileSystems.newFileSystem(zip)) {
            return with(inside.getPath("/"), false);
        }
    }

    private Submission with(Path root, boolean zips) throws IOException {
        List<Path> paths;
        try (Stream<Path> walk = Files.walk(root)) {
            paths = walk.filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)).sorted().toList();
        }
        Submission all = this;
        for (Path file : paths) {
            String place = root.relativize(file).toString().replace('\\', '/');
            if (NOT_HANDED_IN.matcher(place).find()) {
                continue;
            }
            if (zips && isZip(file)) {
                all = all.withZip(file);
            } else if (place.matches(".*[.](java|ya?ml)") && files.size() <= MOST_FILES) {
                try (InputStream bytes = Files.newInputStream(file)) {
                    files.put(place, bytes.readNBytes(LARGEST));
                }
                Instant date = Files.getLastModifiedTime(file).toInstant();
                all = new Submission(name, files, date.isAfter(all.newest) ? date : all.newest);
            }
        }
        return all;
    }

    /** @return a short text that changes with each file */
    String digest() {
        Map<String, String> digests = new TreeMap<>();
        files.forEach((path, bytes) -> digests.put(path,
                Digest.of(new String(bytes, StandardCharsets.ISO_8859_1))));
        return Digest.of(digests.toString());
    }

    /** @return what was not read, in a line */
    List<String> problems() {
        List<String> problems = new ArrayList<>(files.keySet().stream().filter(path -> !path.endsWith(".java")
                && !isPath(path)).map(path -> "no file of this machine can have the name " + path).toList());
        if (files.size() > MOST_FILES) {
            problems.add("there are more than " + MOST_FILES + " YAML and Java files; the others were not read");
        }
        return problems;
    }

    /** Whether a file can have this path here; where the locale is C, only ASCII can be in it. */
    @SuppressWarnings("ReturnValueIgnored")
    private static boolean isPath(String path) {
        try {
            Path.of(path);
            return true;
        } catch (InvalidPathException e) {
            return false;
        }
    }

    /** @return the number that Moodle gave the participant; otherwise the name */
    String id() {
        Matcher moodle = MOODLE.matcher(name);
        return moodle.matches() ? moodle.group(2) : name;
    }

    /**
     * @param words names and numbers from a list of students
     * @return the length of the longest that means this hand-in, by name, number, or the end of assignment-login; or 0
     */
    int longestOf(List<String> words) {
        Matcher moodle = MOODLE.matcher(name);
        return words.stream().filter(word -> moodle.matches() && word.equalsIgnoreCase(moodle.group(1))
                || word.equalsIgnoreCase(id()) || name.toLowerCase(Locale.ROOT).endsWith("-" + word
                .toLowerCase(Locale.ROOT))).mapToInt(String::length).max().orElse(0);
    }

    /**
     * @return the text of each class in a folder exercises; without one, of each class of no other package; of several
     *         with one name, the one that is fewest folders deep
     */
    Map<String, String> sources() {
        Map<String, String> named = new TreeMap<>();
        Map<String, String> others = new TreeMap<>();
        files.keySet().stream().sorted(DEPTH).forEach(path -> {
            String text = new String(files.get(path), StandardCharsets.UTF_8);
            String simple = path.replaceFirst(".*/", "").replaceFirst("[.]java$", "");
            if (path.endsWith(".java") && ("/" + path).contains("/exercises/")) {
                named.putIfAbsent(simple, text);
            } else if (path.endsWith(".java") && !OTHER_PACKAGE.matcher(text).find()) {
                others.putIfAbsent(simple, text);
            }
        });
        return named.isEmpty() ? others : named;
    }

    /**
     * Writes the answers and the YAML files below their folder.
     *
     * @param folder a new folder
     * @return the file of the answers there, which may be missing
     * @throws IOException if something cannot be written
     */
    Path copyAnswers(Path folder) throws IOException {
        Optional<String> answers = files.keySet().stream().filter(path -> path.matches("(.*/)?" + ANSWERS))
                .min(DEPTH);
        String base = answers.map(path -> path.substring(0, path.length() - ANSWERS.length())).orElse("/");
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            String path = file.getKey();
            if (!path.startsWith(base) || path.endsWith(".java") || !isPath(path)) {
                continue;
            }
            Path copy = folder.resolve(path.substring(base.length())).normalize();
            if (copy.startsWith(folder)) {
                Files.createDirectories(copy.getParent());
                Files.write(copy, file.getValue());
            }
        }
        return folder.resolve(ANSWERS);
    }
}
