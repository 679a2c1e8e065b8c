package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;

/** The rows of a sweep survive a stop, and are the same in one run and in parts. */
class SweepCommandTest {
    private static final List<String> FILES = List.of("sweep.csv", "sweep.md", "max-x-of-block.csv",
            "max-x-of-block.png");

    @TempDir
    Path top;

    private String sweep(ExitCode expected, String folder, String... more) {
        String[] args = Stream.concat(Stream.of("sweep", "--scene=3", "--vary=springs[0].damping = 0 .. 4 by 1;"
                + "deltaT = 0.01, 0.02", "--measure=max x of block, evaluations", "--out=" + top.resolve(folder)),
                Stream.of(more)).toArray(String[]::new);
        return Screen.of(expected, List.of(new SweepCommand()), OptionStyle.SHELL, args);
    }

    private Path rows(String folder) throws IOException {
        try (Stream<Path> files = Files.list(top.resolve(folder))) {
            return files.filter(file -> file.getFileName().toString().startsWith("rows-")).findFirst().orElseThrow();
        }
    }

    private void assertSame(String one, String other) throws IOException {
        for (String file : FILES) {
            assertArrayEquals(Files.readAllBytes(top.resolve(one).resolve(file)),
                    Files.readAllBytes(top.resolve(other).resolve(file)), file);
        }
    }

    @Test
    void partsJoinedAreTheBytesOfOneRun() throws IOException {
        sweep(ExitCode.DONE, "whole");
        assertEquals(11, Files.readAllLines(top.resolve("whole/sweep.csv")).size());
        for (int k = 1; k <= 3; k++) {
            assertHas(sweep(ExitCode.DONE, k == 2 ? "parts" : "parts/other", "--part=" + k + "/3"), "make the results");
            if (k < 3) {
                assertHas(sweep(ExitCode.BAD_INPUT, "joined", "--collect=" + top.resolve("parts")),
                        " of 10 runs are not in");
            }
        }
        sweep(ExitCode.DONE, "joined", "--collect=" + top.resolve("parts"));
        assertSame("whole", "joined");
    }

    @Test
    void aSweepThatWasStoppedGoesOn() throws IOException {
        sweep(ExitCode.DONE, "whole");
        List<String> lines = Files.readAllLines(rows("whole"));
        Path stopped = top.resolve("stopped").resolve(rows("whole").getFileName());
        Files.createDirectories(stopped.getParent());
        // five runs, one of them changed to see that it is not computed again, and the beginning of a sixth
        String changed = lines.get(3).replaceFirst(",done$", ",not computed again");
        Files.writeString(stopped, String.join("\n", lines.get(0), lines.get(1), lines.get(2), changed, lines.get(4),
                lines.get(5), lines.get(6).substring(0, 3)));
        sweep(ExitCode.DONE, "stopped");
        List<String> again = Files.readAllLines(top.resolve("stopped/sweep.csv"));
        assertTrue(again.contains(changed), again.toString());
        List<String> whole = Files.readAllLines(top.resolve("whole/sweep.csv"));
        assertEquals(whole, again.stream().map(line -> line.replace("not computed again", "done")).toList());
    }

    /** Rows of other measures, or of another scene, have a file of their own. */
    @Test
    void rowsOfAnotherSweepAreLeftAlone() throws IOException {
        sweep(ExitCode.DONE, "both");
        Path first = rows("both");
        byte[] before = Files.readAllBytes(first);
        sweep(ExitCode.DONE, "both", "--set=springs[0].stiffness=50");
        assertArrayEquals(before, Files.readAllBytes(first));
        assertFalse(Files.readAllLines(top.resolve("both/sweep.csv")).equals(Files.readAllLines(first)));
    }
}
