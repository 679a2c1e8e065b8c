package particles.scene;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.scene.parts.NamedFiles;
import particles.scene.parts.NamedFiles.NamedFile;
import particles.spec.ClassNames;
import particles.spec.Reading;
import particles.spec.Setting;
import particles.spec.SourceText;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/** Reads and checks scene files; reports all mistakes together, each with its line and column. */
public final class SceneReader {
    private static final int MOST_BYTES = Integer.MAX_VALUE - 16;           // the longest array

    private SceneReader() {
    }

    /**
     * Reads a file.
     *
     * @param file a scene file; messages name it as given here
     * @return the contents of the scene
     * @throws InvalidInputException with everything that is wrong with it
     */
    public static SceneDescription read(Path file) {
        return read(file, ClassNames.none());
    }

    /**
     * Reads a file that may name students' classes.
     *
     * @param file    a scene
     * @param classes finds classes that the file names
     * @return the contents of the scene
     * @throws InvalidInputException with everything that is wrong with it
     */
    public static SceneDescription read(Path file, ClassNames classes) {
        return read(file, classes, List.of());
    }

    /** The same, with these values in place of the file's own. */
    public static SceneDescription read(Path file, ClassNames classes, List<Setting> settings) {
        return read(nameOf(file), bytes(file), classes, beside(file), settings);
    }

    /** @return finds the files in the folder of a scene */
    public static NamedFiles beside(Path scene) {
        return (name, place, problems) -> {
            Path file = scene.resolveSibling(name);
            return SourceText.read(file, MOST_BYTES, new Reading(nameOf(file), problems)).map(bytes ->
                    new NamedFile(nameOf(file), new String(bytes, StandardCharsets.UTF_8)));
        };
    }

    /**
     * @param file    a scene
     * @param classes finds classes that the file names
     * @return its text, followed by the files that it names, so that the text can be read alone
     * @throws InvalidInputException with everything that is wrong with it
     */
    public static String withFiles(Path file, ClassNames classes) {
        return withFiles(file, classes, List.of());
    }

    /** The same, followed by the files that it names with these values in place of its own. */
    public static String withFiles(Path file, ClassNames classes, List<Setting> settings) {
        StringBuilder text = new StringBuilder(new String(bytes(file), StandardCharsets.UTF_8));
        List<String> added = new ArrayList<>(List.of("\nfiles:\n"));
        read(nameOf(file), bytes(file), classes, (name, place, problems) -> {
            Optional<NamedFile> found = beside(file).read(name, place, problems);
            found.ifPresent(one -> added.add("  '" + name + "': |2\n" + one.text().indent(4)));
            return found;
        }, settings);
        added.stream().limit(added.size() > 1 ? added.size() : 0).forEach(text::append);
        return text.toString();
    }

    /** @return a file's name in messages: its path, with slashes on any system */
    public static String nameOf(Path file) {
        return file.toString().replace('\\', '/');
    }

    /**
     * @param file a file
     * @return its bytes
     * @throws InvalidInputException if it cannot be read
     */
    public static byte[] bytes(Path file) {
        Problems problems = new Problems();
        return SourceText.read(file, new Reading(nameOf(file), problems))
                .orElseThrow(() -> new InvalidInputException(problems.lines()));
    }

    /**
     * Reads a scene from bytes.
     *
     * @param source the file's name in messages
     * @param bytes  its bytes
     * @return the contents of the scene
     * @throws InvalidInputException with everything that is wrong with it
     */
    public static SceneDescription read(String source, byte[] bytes) {
        return read(source, bytes, ClassNames.none());
    }

    /** As {@link #read(String, byte[])}, with classes as in {@link #read(Path, ClassNames)}. */
    public static SceneDescription read(String source, byte[] bytes, ClassNames classes) {
        return read(source, bytes, classes, List.of());
    }

    /** The same, with these values in place of the scene's own. */
    public static SceneDescription read(String source, byte[] bytes, ClassNames classes, List<Setting> settings) {
        return read(source, bytes, classes, (name, place, problems) -> problems.add(place,
                "no other file can be read here; put its text under 'files'"), settings);
    }

    /**
     * The same, for a scene that may name files.
     *
     * @param files finds the files that are not in the scene itself
     */
    public static SceneDescription read(String source, byte[] bytes, ClassNames classes, NamedFiles files) {
        return read(source, bytes, classes, files, List.of());
    }

    private static SceneDescription read(String source, byte[] bytes, ClassNames classes, NamedFiles files,
            List<Setting> settings) {
        Problems problems = new Problems();
        return SceneFormat.SCENE.read(bytes, settings, new Reading(source, problems, classes))
                .flatMap(values -> SceneChecks.describe(values, files, problems))
                .orElseThrow(() -> new InvalidInputException(problems.lines()));
    }

    /** @return the unit of a number that is set in a scene; empty if what is set is no number, or has no unit */
    public static String unit(Path file, ClassNames classes, Setting setting) {
        Reading in = new Reading(nameOf(file), new Problems(), classes);
        SceneFormat.SCENE.read(bytes(file), List.of(setting), in);
        return in.numbers().stream().filter(number -> number.place().equals(setting.getPlace())).map(
                Reading.NumberInText::unit).findFirst().orElse("");
    }

    /**
     * @return the numbers in a scene's text and in what is set in it, in the order in which they are read; where there
     *         are mistakes, the others
     */
    public static List<Reading.NumberInText> numbers(byte[] bytes, ClassNames classes, List<Setting> settings) {
        Reading in = new Reading("", new Problems(), classes);
        SceneFormat.SCENE.read(bytes, settings, in);
        return in.numbers();
    }
}
