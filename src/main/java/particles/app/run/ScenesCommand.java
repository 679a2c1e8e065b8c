package particles.app.run;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import particles.app.cli.ProgramCommand;
import particles.app.student.StudentClasses;
import particles.scene.SceneFiles;
import particles.scene.SceneFiles.SceneName;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;

/** {@code gradle scenes}: lists the scenes, each with its lesson. */
@Command(name = "scenes", description = "Lists the scenes and what each teaches.")
public final class ScenesCommand extends ProgramCommand {
    /** A longer word or words of at most 105 characters, and what separates them from the next. */
    private static final String LINE = "(\\S{105,}|.{1,105})(?: |$)";
    private static final String INDENT = "    ";

    private final Path folder;

    /** @param folder the folder of the scenes */
    public ScenesCommand(Path folder) {
        this.folder = folder;
    }

    @Override
    public void run(PrintWriter out) {
        List<Path> files = SceneFiles.list(folder);
        if (files.isEmpty()) {
            throw new InvalidInputException("there is no scene in the folder " + folder.toAbsolutePath());
        }
        List<String> problems = new ArrayList<>();
        for (Path file : files) {
            try {
                print(file, SceneReader.read(file, new StudentClasses()), out);
            } catch (InvalidInputException e) {
                problems.addAll(e.getLines());          // go on with the other scenes
            }
        }
        if (!problems.isEmpty()) {
            throw new InvalidInputException(problems);
        }
    }

    private static void print(Path file, SceneDescription scene, PrintWriter out) {
        SceneName name = SceneName.of(file);
        out.printf("%-3s %s: %s (%s)%n", name.number(), name.bare(), scene.title(), scene.solver());
        out.print(scene.values().get(SceneFormat.TEACHES).strip().replaceAll("\\s+", " ")
                .replaceAll(LINE, INDENT + "$1" + System.lineSeparator()));
    }
}
