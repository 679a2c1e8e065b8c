package particles.scene;

import java.nio.file.Path;
import java.util.List;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.ClassNames;
import particles.spec.Reading;
import particles.spec.SourceText;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/** Reads and checks scene files; reports all mistakes together, each with its line and column. */
public final class SceneReader {
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
        return read(nameOf(file), bytes(file), classes);
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
        Problems problems = new Problems();
        return SceneFormat.SCENE.read(bytes, new Reading(source, problems, classes))
                .flatMap(values -> SceneChecks.describe(values, problems))
                .orElseThrow(() -> new InvalidInputException(problems.lines()));
    }

    /** @return the numbers in a scene's text, in the order in which they are read; of what has mistakes, the others */
    public static List<Reading.NumberInText> numbers(byte[] bytes, ClassNames classes) {
        Reading in = new Reading("", new Problems(), classes);
        SceneFormat.SCENE.read(bytes, in);
        return in.numbers();
    }
}
