package particles.scene;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.scene.parts.NamedFiles;
import particles.scene.parts.NamedFiles.NamedFile;
import particles.spec.ClassNames;
import particles.spec.Reading;
import particles.spec.Reading.NumberInText;
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

    /** Finds the files in the folder of a scene. */
    private static NamedFiles beside(Path scene) {
        return (name, place, problems) -> {
            Path file = scene.resolveSibling(name);
            return SourceText.read(file, MOST_BYTES, new Reading(nameOf(file), problems)).map(bytes ->
                    new NamedFile(nameOf(file), new String(bytes, StandardCharsets.UTF_8)));
        };
    }

    /**
     * @param file     a scene
     * @param classes  finds classes that the file names
     * @param settings values in place of the file's own
     * @return its text, followed by the files that it names with these values, so that the text can be read alone
     * @throws InvalidInputException with everything that is wrong with it
     */
    public static String withFiles(Path file, ClassNames classes, List<Setting> settings) {
        String text = new String(bytes(file), StandardCharsets.UTF_8);
        StringBuilder added = new StringBuilder();
        read(nameOf(file), bytes(file), classes, (name, place, problems) -> {
            Optional<NamedFile> found = beside(file).read(name, place, problems);
            found.ifPresent(one -> added.append("  '" + name + "': |2\n" + one.text().indent(4)));
            return found;
        }, settings);
        return added.isEmpty() ? text : text + "\nfiles:\n" + added;
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
        return read(source, bytes, ClassNames.none(), List.of());
    }

    /** The same, for a scene that may name classes, with these values in place of its own. */
    public static SceneDescription read(String source, byte[] bytes, ClassNames classes, List<Setting> settings) {
        return read(source, bytes, classes, (name, place, problems) -> problems.add(place,
                "no other file can be read here; put its text under 'files'"), settings);
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
        return numbers(bytes(file), classes, List.of(setting)).stream()
                .filter(number -> number.place().equals(setting.getPlace())).map(NumberInText::unit).findFirst()
                .orElse("");
    }

    /**
     * @return the numbers in a scene's text and in what is set in it, in the order in which they are read; where there
     *         are mistakes, the others
     */
    public static List<NumberInText> numbers(byte[] bytes, ClassNames classes, List<Setting> settings) {
        Reading in = new Reading("", new Problems(), classes);
        SceneFormat.SCENE.read(bytes, settings, in);
        return in.numbers();
    }
}
