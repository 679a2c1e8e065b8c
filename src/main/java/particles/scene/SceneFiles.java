package particles.scene;

import static particles.spec.messages.Wording.quote;

import deSolvers.text.DidYouMean;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Wording;

/** Finds scenes: by path, by name with or without number, or by number. */
public final class SceneFiles {
    /** The default scene. */
    public static final String DEFAULT = "cloth-in-wind";

    private SceneFiles() {
    }

    /**
     * @param folder the folder of the scenes
     * @return its scenes, sorted by name and so by number
     * @throws InvalidInputException if there is no such folder
     */
    public static List<Path> list(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().matches("[^.].*\\.yaml")).sorted().toList();
        } catch (IOException | UncheckedIOException e) {
            throw new InvalidInputException("the folder of scenes, " + folder
                    + ", cannot be read; run this in the project's folder, or give the path of a scene");
        }
    }

    /**
     * Finds one scene.
     *
     * @param folder the folder of the scenes
     * @param wanted a path; or the name of a scene of the folder, such as {@code 09-cloth-in-wind},
     *               {@code cloth-in-wind}, either with the ending too; or its number, {@code 9} or {@code 09}
     * @return the file
     * @throws InvalidInputException if there is none, or more than one
     */
    public static Path find(Path folder, String wanted) {
        Optional<Path> typed = pathOf(wanted);
        if (typed.filter(Files::isRegularFile).isPresent()) {
            return typed.get();
        }
        // names of scenes contain no folder
        boolean inFolder = typed.filter(path -> path.getNameCount() > 1 || path.isAbsolute()).isPresent();
        List<Path> found = inFolder ? List.of() : list(folder).stream()
                .filter(file -> SceneName.of(file).isCalled(wanted.replaceFirst("\\.yaml$", ""))).toList();
        if (found.size() == 1) {
            return found.get(0);
        }
        throw new InvalidInputException(!found.isEmpty() ? quote(wanted) + " matches more than one scene: "
                + String.join(", ", found.stream().map(Path::toString).toList()) + "; give the whole name"
                : typed.filter(path -> inFolder || Files.exists(path)).map(path -> noFile(folder, path))
                        .orElseGet(() -> "there is no scene " + quote(wanted) + nearest(folder, wanted)));
    }

    /** The message for a path that is not a scene. */
    private static String noFile(Path folder, Path typed) {
        String quoted = Wording.quoteWhole(typed.toString());
        if (Files.exists(typed)) {
            return quoted + " is " + (Files.isDirectory(typed) ? "a folder" : "a device, a pipe or a socket")
                    + "; a scene is an ordinary file";
        }
        List<String> names = list(folder).stream().map(file -> file.getFileName().toString()).toList();
        return "there is no file " + quoted + DidYouMean.nearest(typed.getFileName().toString(), names)
                .map(name -> "; did you mean '" + name + "'?").orElse("");
    }

    private static Optional<Path> pathOf(String wanted) {
        try {
            return wanted.isBlank() ? Optional.empty() : Optional.of(Path.of(wanted));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    private static String nearest(Path folder, String wanted) {
        List<SceneName> scenes = list(folder).stream().map(SceneName::of).toList();
        String bare = SceneName.of(wanted.replace('\\', '/').replaceFirst(".*/", "")).bare();
        return Wording.hint(bare, scenes.stream().map(SceneName::bare).toList()) + " scenes: "
                + String.join(", ", scenes.stream().map(SceneName::whole).toList());
    }

    /**
     * The parts of a scene file's name: {@code 02-one-spring.yaml} has number {@code 02} and bare name
     * {@code one-spring}.
     *
     * @param whole  the name without extension, used for results
     * @param number the digits before the first dash, or empty
     * @param bare   the whole name without the number
     */
    public record SceneName(String whole, String number, String bare) {

        /** @return the parts of a scene file's name */
        public static SceneName of(Path file) {
            return of(file.getFileName().toString());
        }

        static SceneName of(String file) {
            String whole = file.replaceFirst("\\.ya?ml$", "");
            if (!whole.matches("\\d+-.+")) {
                return new SceneName(whole, "", whole);
            }
            int dash = whole.indexOf('-');
            return new SceneName(whole, whole.substring(0, dash), whole.substring(dash + 1));
        }

        /** Whether the scene can be called so: by its name, with or without number, or by its number. */
        boolean isCalled(String name) {
            return whole.equals(name) || bare.equals(name)
                    || number.length() > 0 && (number.equals(name) || number.replaceFirst("^0+(?=.)", "").equals(name));
        }
    }
}
