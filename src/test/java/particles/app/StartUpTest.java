package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The cost of starting, in loaded classes: unused ones are not loaded. */
class StartUpTest {
    private static final String PICTURES =
            "java\\.awt\\..*|sun\\.(awt|java2d|font)\\..*|javax\\.imageio\\..*|org\\.(jfree|jcodec)\\..*";
    private static final String ALGEBRA = "org\\.ejml\\..*|edu\\.ufl\\..*";
    private static final String SCENE = """
            title: A spring
            teaches: What starting costs.
            solver: rk4
            deltaT: 0.05
            duration: 1
            particles:
              - {id: wall, position: [0, 0, 0], fixed: true}
              - {id: block, position: [1, 0, 0]}
            springs:
              - {from: wall, to: block, stiffness: 1, restLength: 0.5}
            output: {energy: ENERGY}
            """;

    @TempDir
    Path top;

    private List<String> loaded(boolean energy) throws IOException, InterruptedException {
        Path scene = Files.writeString(top.resolve("scene.yaml"), SCENE.replace("ENERGY", Boolean.toString(energy)));
        Path classes = top.resolve("classes.txt");
        ChildProgram.End end = new ChildProgram(top.resolve("lines.txt"))
                .jvm("-Xlog:class+load:file=" + classes + "::filesize=0")
                .run("run", "--scene=" + scene, "--frames=false", "--out=" + top.resolve("out"));
        assertEquals(0, end.code(), end.lines());
        return Files.readAllLines(classes).stream().map(line -> line.replaceFirst("^(\\[[^\\]]*\\])* ?",
                "").split(" ")[0]).toList();
    }

    private static List<String> of(List<String> loaded, String which) {
        return loaded.stream().filter(name -> name.matches(which)).toList();
    }

    /** Options are found by reflection, only for the named command. */
    @Test
    void aRunThatDrawsNothingLoadsNothingThatDrawsAndNoOtherCommand() throws IOException, InterruptedException {
        List<String> loaded = loaded(false);
        assertTrue(loaded.containsAll(List.of("deSolvers.RK4Solver", "particles.app.run.RunCommand")),
                loaded.size() + " classes");
        assertEquals(List.of(), of(loaded, PICTURES));
        assertEquals(List.of(), of(loaded, ALGEBRA));
        assertEquals(List.of(), of(loaded, "particles\\.(experiments\\.problems|teaching)\\..*"));
    }

    /** A record's own equals makes Java generate code at run time, which takes several per cent of a short run. */
    @Test
    void aChartNeedsNoPictureLibraryOfJavaAndNoGeneratedEquals() throws IOException, InterruptedException {
        List<String> loaded = loaded(true);
        assertTrue(loaded.contains("org.jfree.chart.JFreeChart"), loaded.size() + " classes");
        assertEquals(List.of(), of(loaded, "javax\\.imageio\\..*|com\\.sun\\.imageio\\..*|org\\.jcodec\\..*"
                + "|java\\.lang\\.runtime\\.ObjectMethods.*"));
    }
}
