package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import particles.app.Main;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.app.run.StopRequest;

/** Every task that takes a scene handles scenes in which nothing moves, nothing is left, or everything is far away. */
class EdgeScenesTest {
    private static final String HEAD = "title: Edge\nteaches: what tasks bear\nsolver: rk4\ndeltaT: 0.01\n"
            + "duration: 0.2\noutput: {width: 64, height: 48}\nparticles:\n";

    @TempDir
    Path top;

    static Stream<Arguments> tasksAndScenes() {
        List<Arguments> all = new ArrayList<>();
        for (String task : List.of("run", "energyDrift", "phasePlots", "race")) {
            all.add(Arguments.of(task, "all are fixed", "  - {id: a, position: [0, 1, 0], fixed: true}\n"));
            all.add(Arguments.of(task, "all die", "  - {id: a, position: [0, 0.1, 0], velocity: [0, -1, 0]}\n"
                    + "rules:\n  - kill: {point: [0, 0, 0]}\n"));
            all.add(Arguments.of(task, "one is far away",
                    "  - {id: a, position: [1e30, 0, 0]}\n  - {id: b, position: [0, 0, 0]}\n"));
        }
        return all.stream();
    }

    @ParameterizedTest(name = "{0} where {1}")
    @MethodSource("tasksAndScenes")
    void noTaskEndsInAStackTrace(String task, String what, String particles) throws IOException {
        Path scene = Files.writeString(top.resolve("edge.yaml"), HEAD + particles);
        List<String> args = new ArrayList<>(List.of(task, "--scene=" + scene, "--out=" + top.resolve("out")));
        if (task.equals("race")) {
            args.add("--solvers=euler,rk4");
        }
        Screen screen = Screen.of(Main.commands(new StopRequest()), OptionStyle.SHELL, args.toArray(String[]::new));
        boolean noPath = task.equals("phasePlots") && what.equals("all are fixed");
        assertEquals(new Screen(noPath ? ExitCode.BAD_INPUT : ExitCode.DONE, screen.out(), noPath ? "option --scene: at"
                + " its start this scene has no free particle, so there is no path to draw" : ""), screen);
    }
}
