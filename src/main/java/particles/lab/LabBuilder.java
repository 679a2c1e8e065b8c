package particles.lab;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;

/** Builds the lab's page. The implementation needs a compiler that only {@code gradle lab} downloads. */
public interface LabBuilder {

    /**
     * The content of the page.
     *
     * @param scenes   the texts of its scenes
     * @param pictures small pictures of scenes, as JPEG files
     * @param first    the one that it opens with
     * @param solver   the solver that it opens with, if it is not the scene's; else empty
     * @param solvers  the full names of students' solvers
     * @param classes  finds the classes of the page
     */
    record Contents(Map<Path, String> scenes, Map<Path, byte[]> pictures, Path first, String solver,
            Collection<String> solvers, ClassLoader classes) {
    }

    /**
     * @param contents the contents of the page
     * @param folder   receives the files of the compiler
     * @return the page
     * @throws IOException              if a file cannot be read or written
     * @throws IllegalArgumentException if a class does not compile for a page; the message is one line
     */
    String build(Contents contents, Path folder) throws IOException;
}
