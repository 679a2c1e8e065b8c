package particles.app.run;

import deSolvers.catalog.SolverCatalog;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import particles.app.cli.ProgramCommand;
import particles.app.cli.ResultsCommand;
import particles.app.student.PageClasses;
import particles.app.student.StudentClasses;
import particles.lab.LabBuilder;
import particles.output.animation.Shrinker;
import particles.output.files.OutputFile;
import particles.output.files.TemporaryFolder;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.messages.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle lab}: one page that runs scenes in a browser. */
@Command(name = "lab", description = "Writes a page that runs scenes in a browser: build/out/lab/index.html.")
public final class LabCommand extends ProgramCommand {
    private static final Path PAGE = ResultsCommand.RESULTS.resolve("lab/index.html");
    private static final String BUILDER = "particles.lab.compile.PageBuilder";

    @Option(names = "--scene", paramLabel = "NAME",
            description = "The scene that it opens with: a file, or the name or number of one in scenes.")
    private String scene = SceneFiles.DEFAULT;

    @Option(names = "--solver", paramLabel = "CLASS", description = "A solver of your own that is in the page too.")
    private String solver = "";

    private final Path folder;
    private final Path exercises;

    /**
     * @param folder    the folder of the scenes
     * @param exercises the folder of students' classes
     */
    public LabCommand(Path folder, Path exercises) {
        this.folder = folder;
        this.exercises = exercises;
    }

    @Override
    public void run(PrintWriter out) throws IOException {
        Path first = SceneFiles.find(folder, scene);
        List<Path> scenes = new ArrayList<>(SceneFiles.list(folder));
        if (scenes.stream().noneMatch(file -> file.toAbsolutePath().equals(first.toAbsolutePath()))) {
            scenes.add(first);
        }
        Set<String> solvers = new TreeSet<>(List.of(solver));
        Set<String> effects = new TreeSet<>();
        Map<Path, String> texts = new LinkedHashMap<>();
        for (Path file : scenes) {
            SceneDescription description = SceneReader.read(file, new StudentClasses());
            texts.put(file, SceneReader.withFiles(file, new StudentClasses(), List.of()));
            solvers.add(description.solver());
            description.values().get(SceneFormat.EFFECTS).stream().map(effect -> effect.kind().getName())
                    .filter(name -> name.contains(".")).forEach(effects::add);
        }
        solvers.remove("");
        solvers.removeAll(SolverCatalog.names());
        solvers.forEach(name -> made("solver", () -> SolverCatalog.create(name)));
        LabBuilder builder = builder();
        try (TemporaryFolder own = new TemporaryFolder("lab")) {
            String page = builder.build(new LabBuilder.Contents(texts, pictures(scenes), first, solver, solvers,
                    PageClasses.compile(solvers, effects, exercises, own.getPath())), own.getPath());
            Files.createDirectories(PAGE.getParent());
            OutputFile.write(PAGE, page.getBytes(StandardCharsets.UTF_8));
        }
        out.println(PAGE + ": " + Math.round(Files.size(PAGE) / 1e4) / 100.0 + " MB; open it in a browser");
    }

    /**
     * Makes the gallery's pictures small: in full size they would be half of the page.
     *
     * @param scenes files of scenes
     * @return a JPEG file for each scene that has a picture
     * @throws IOException if one cannot be read
     */
    public static Map<Path, byte[]> pictures(List<Path> scenes) throws IOException {
        Map<Path, byte[]> pictures = new HashMap<>();
        for (Path file : scenes) {
            String name = file.getFileName().toString().replace(".yaml", ".png");
            Path drawn = file.resolveSibling("pictures").resolve(name);
            if (Files.exists(drawn)) {
                pictures.put(file, Shrinker.jpeg(drawn, 2));
            }
        }
        return pictures;
    }

    private static LabBuilder builder() {
        try {
            return Class.forName(BUILDER).asSubclass(LabBuilder.class).getConstructor().newInstance();
        } catch (ReflectiveOperationException e) {
            throw new InvalidInputException("the page's compiler is not here; type: gradle lab");
        }
    }
}
