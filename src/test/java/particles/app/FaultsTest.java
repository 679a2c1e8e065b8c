package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.OtherSystems;

/**
 * Faults around the program, each in a child process: files are whole or absent, the message is one clear line with the
 * right exit code, and results so far are kept.
 */
@Tag("slow")
class FaultsTest {
    /** Long enough to be stopped in the middle (s of simulated time). */
    private static final double LONG = 6;
    private static final double SHORT = 0.6;
    private static final boolean KNOWS_ALL_LETTERS = "UTF-8".equals(System.getProperty("sun.jnu.encoding"));

    @TempDir
    Path top;
    private Path out;

    @BeforeEach
    void nameFolder() {
        out = top.resolve("out");
    }

    private Path scene(double duration) throws IOException {
        return FaultScene.write(top.resolve("scene.yaml"), duration);
    }

    private ChildProgram child() {
        return new ChildProgram(top.resolve("lines.txt"));
    }

    private Map<String, String> unbroken(Path scene) throws Exception {
        Path whole = top.resolve("whole");
        done(child(), scene, whole);
        return WholeFiles.sums(whole);
    }

    /** Runs a scene to its end, or to that of the program. */
    private ChildProgram.End run(ChildProgram child, Path scene, Path folder) throws Exception {
        return child.end(start(child, scene, folder));
    }

    /** Runs a scene, which has to come to its end, and returns its lines. */
    private String done(ChildProgram child, Path scene, Path folder) throws Exception {
        ChildProgram.End end = run(child, scene, folder);
        assertEquals(0, end.code(), end.lines());
        return end.lines();
    }

    private static Process start(ChildProgram child, Path scene, Path folder) throws IOException {
        return child.start("run", "--scene=" + scene, "--out=" + folder);
    }

    private static void assertOneLine(int code, String pattern, ChildProgram.End end) {
        assertEquals(code, end.code(), end.lines());
        assertTrue(end.lastLine().matches(pattern), end.lines());
        assertFalse(end.lines().contains("\tat ") || end.lines().contains("Exception"), end.lines());
    }

    private void awaitFile(Process process, Path file, ChildProgram child) throws Exception {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(ChildProgram.PATIENCE_SECONDS);
        while (!Files.exists(file)) {
            assertTrue(process.isAlive() && System.nanoTime() < end, child.lines());
            Thread.sleep(10);
        }
    }

    /** A process that a script starts in the background may ignore a signal, and so do the processes it starts. */
    private static boolean hears(int signal) throws IOException {
        Path status = Path.of("/proc/self/status");
        return !Files.exists(status) || Files.readAllLines(status).stream().filter(line -> line.startsWith("SigIgn:"))
                .allMatch(line -> (Long.parseUnsignedLong(line.substring(7).strip(), 16) >> signal - 1 & 1) == 0);
    }

    /** Signals 1, 2 and 15: the terminal was closed, Ctrl-C, and kill. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 15})
    void aSignalEndsARunWithALineAndWholeFiles(int signal) throws Exception {
        OtherSystems.assumeSignals();
        assumeTrue(hears(signal), "the signal is ignored here: run it in the foreground");
        Path scene = scene(LONG);
        Map<String, String> expected = unbroken(scene);
        ChildProgram child = child();
        Process process = start(child, scene, out);
        awaitFile(process, out.resolve("frames/frame-00003.png"), child);
        assertEquals(0, new ProcessBuilder("kill", "-" + signal, Long.toString(process.pid())).start().waitFor());
        ChildProgram.End end = child.end(process);
        assertOneLine(128 + signal, "the run was stopped at t = [0-9.]+ s of 6 s", end);
        for (String name : List.of("trajectory.csv", "run.json", "energy.png", "animation.gif")) {
            assertTrue(Files.size(out.resolve(name)) > 0, name);
        }
        WholeFiles.assertWhole(out);
        try (Stream<Path> files = Files.walk(out)) {
            assertEquals(List.of(), files.filter(file -> file.toString().endsWith(".part")).toList());
        }
        done(child(), scene, out);
        assertEquals(expected, WholeFiles.sums(out));
    }

    /** A limited file size, which acts like a quota or full disk, is reached by the trajectory. */
    @Test
    void aFullDiskEndsTheRunWithALineAndNoHalfFile() throws Exception {
        OtherSystems.assumeBash();                      // for its ulimit
        Path scene = scene(3);
        Map<String, String> expected = unbroken(scene);
        long kilobytes = Files.size(top.resolve("whole/trajectory.csv")) * 3 / 4 / 1024;
        ChildProgram.End end = run(child().startedBy("/bin/bash", "-c", "ulimit -f " + kilobytes + "; exec \"$@\"",
                "bash"), scene, out);
        assertOneLine(1, "cannot write .*/trajectory.csv: File too large.*", end);
        WholeFiles.assertWhole(out);
        assertFalse(Files.exists(out.resolve("trajectory.csv")), "the part that was written is not the file");
        done(child(), scene, out);
        assertEquals(expected, WholeFiles.sums(out));
    }

    /** The other side of the pipe has gone before the first line, as head does after its lines. */
    @ParameterizedTest
    @ValueSource(strings = {"scenes", "solvers", "exercise", "--help", "checkSolver --solver=rk4", "run"})
    void aPipeThatNobodyReadsIsNoFault(String command) throws Exception {
        assumeTrue(Files.exists(Path.of("/dev/stdout")), "needs pipes with names");
        String[] args = (command.equals("run") ? "run --scene=" + scene(SHORT) + " --out=" + out : command).split(" ");
        ChildProgram.End end = child().startedBy("sh", "-c", "{ \"$@\"; echo \"exit $?\" >&2; } | true", "sh")
                .run(args);
        assertEquals("exit 0", end.lines().strip());
    }

    /** A device that is always full takes the lines of a run; what is lost is said on the other stream. */
    @Test
    void linesThatCannotBePrintedAreNotLostInSilence() throws Exception {
        assumeTrue(Files.exists(Path.of("/dev/full")), "needs a device that is always full");
        ChildProgram.End end = run(child().startedBy("sh", "-c", "\"$@\" >/dev/full", "sh"), scene(SHORT), out);
        assertEquals(1, end.code(), end.lines());
        assertEquals("some output could not be printed: the destination is full or closed", end.lines().strip());
        WholeFiles.assertWhole(out);
        assertTrue(Files.exists(out.resolve("run.json")), "the results are written all the same");
    }

    @Test
    void aFolderThatNobodyMayWriteToIsOneLine() throws Exception {
        assumeTrue(Files.isDirectory(Path.of("/proc/self")), "needs a folder in which not even root may write");
        assertOneLine(1, "cannot create the folder /proc/desolver: .+",
                run(child(), scene(SHORT), Path.of("/proc/desolver")));
    }

    @Test
    void aFolderThatVanishesEndsTheRunWithALine() throws Exception {
        Path scene = scene(10_000);
        ChildProgram child = child();
        Process process = start(child, scene, out);
        awaitFile(process, out.resolve("frames/frame-00003.png"), child);
        Files.move(out, top.resolve("elsewhere"));
        ChildProgram.End end = child.end(process);
        assertOneLine(1, "cannot write .*: its folder does not exist", end);
        assertFalse(Files.exists(out), "it does not come back");
    }

    /** Nothing is written beside scenes, so they may be on a read-only disk. */
    @Test
    void scenesMayBeReadOnly() throws Exception {
        Path folder = Files.createDirectory(top.resolve("read only"));
        Path scene = FaultScene.write(folder.resolve("scene.yaml"), SHORT);
        Map<String, String> before = WholeFiles.sums(folder);
        assertTrue(scene.toFile().setWritable(false) && folder.toFile().setWritable(false));
        done(child(), scene, out);
        assertTrue(folder.toFile().setWritable(true));
        assertEquals(before, WholeFiles.sums(folder));
    }

    /** Charts need fonts; numbers do not. */
    @Test
    void withoutFontsThereAreNumbersAndAClearLine() throws Exception {
        Path none = Files.writeString(top.resolve("fonts.conf"), "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
        Path scene = scene(SHORT);
        ChildProgram.End end = run(child().environment("FONTCONFIG_FILE", none.toString()).jvm(
                "-Dsun.java2d.fontpath=" + top, "-Duser.home=" + top, "-Dsun.awt.fontconfig=" + top.resolve("none")),
                scene, out);
        WholeFiles.assertWhole(out);
        assertTrue(Files.exists(out.resolve("trajectory.csv")) && Files.exists(out.resolve("run.json")), end.lines());
        if (end.code() != 0) {                          // a Java that brings fonts of its own draws all the same
            assertOneLine(1, "cannot draw .*: Java finds no font on this machine.*", end);
        }
    }

    /**
     * Commas for points, Arabic digits, a dotless i, other calendars: numbers in files and lines are always the same.
     */
    @Test
    void languageAndTimeZoneChangeNothing() throws Exception {
        Path scene = scene(SHORT);
        String usual = done(child(), scene, out);
        Map<String, String> expected = WholeFiles.sums(out);
        for (String options : List.of("-Duser.language=de -Duser.country=DE", "-Duser.language=tr -Duser.country=TR",
                "-Duser.language=ar -Duser.country=EG -Duser.extensions=u-nu-arab",
                "-Duser.language=th -Duser.country=TH -Duser.variant=TH", "-Duser.timezone=Pacific/Kiritimati",
                "-Dfile.encoding=UTF-16")) {
            String lines = done(child().jvm("-Dstdout.encoding=UTF-8", "-Dstderr.encoding=UTF-8")
                    .jvm(options.split(" ")), scene, out);
            assertEquals(expected, WholeFiles.sums(out), options);
            if (!options.contains("UTF-16")) {          // in which Java 17 prints too
                assertEquals(withoutTime(usual), withoutTime(lines), options);
            }
        }
    }

    /** Removes lines that depend on the machine's speed: run time, estimate and progress. */
    private static String withoutTime(String lines) {
        return lines.replaceAll("run time [0-9.]+ s",
                "run time").replaceAll("(?m)^(this takes about .*|t = .* to go)\n", "");
    }

    @Test
    void foldersMayHaveSpacesAndAnyLetters() throws Exception {
        assumeTrue(KNOWS_ALL_LETTERS, "this Java cannot even name such files");
        Path folder = top.resolve("Übung 1, Lösung — 物理");
        Path expected = top.resolve("plain");
        FaultScene.write(top.resolve("scene.yaml"), SHORT);
        done(child(), top.resolve("scene.yaml"), expected);
        Path scene = FaultScene.write(Files.createDirectory(folder).resolve("scene.yaml"), SHORT);
        done(child().environment("LC_ALL", "C.UTF-8"), scene, folder.resolve("größe 2"));
        assertEquals(WholeFiles.sums(expected), WholeFiles.sums(folder.resolve("größe 2")));
    }

    /** A system whose encoding has no umlauts may refuse such file names: one line, and nothing else is written. */
    @Test
    void namesThatTheSystemCannotEncodeAreOneLine() throws Exception {
        assumeTrue(KNOWS_ALL_LETTERS, "this Java cannot even name such files");
        Path scene = scene(SHORT);
        assertOneLine(2, ".* is not a folder name: Malformed input or input contains unmappable characters",
                run(child().environment("LC_ALL", "C"), scene, top.resolve("\u00fcbung")));
    }
}
