package particles.scene.parts;

import java.util.Optional;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/** Finds the files that a source names, such as meshes. */
@FunctionalInterface
public interface NamedFiles {
    /**
     * A file.
     *
     * @param name its name in messages
     * @param text its text
     */
    record NamedFile(String name, String text) {
    }

    /**
     * @param name     the name of a file, as the source has it
     * @param place    where the source has it
     * @param problems receives the problem if it cannot be read
     * @return the file, or empty if a problem was reported
     */
    Optional<NamedFile> read(String name, Place place, Problems problems);
}
