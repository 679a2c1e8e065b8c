package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertMatches;
import static particles.Texts.assertStarts;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.text.Digits;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.cli.Screen;
import particles.scene.SceneFiles;

/** Runs through the program: files, output and exit codes. */
class RunCommandTest {
    /** A block on a spring, omega = 10 rad/s; pictures as small as they can be read. */
    private static final String SCENE = """
            title: A block
            teaches: Nothing but that it runs.
            solver: rk4
            deltaT: 0.01
            duration: 0.5
            particles:
              - {id: wall, position: [0, 0, 0], fixed: true}
              - {id: block, position: [1.5, 0, 0], mass: 2}
            springs:
              - {from: wall, to: block, stiffness: 200, restLength: 1}
            output:
              {frameRate: 10, width: 64, height: 48, phase: {particle: block, axis: x}}
            """;

    @TempDir
    Path top;
    private Path scenes;
    private Path out;
    private Screen screen;

    @BeforeEach
    void writeScene() throws IOException {
        scenes = Files.createDirectory(top.resolve("scenes"));
        writeScene(SCENE);
        out = top.resolve("out");
    }

    private ExitCode run(String... options) {
        return run(new StopRequest(), options);
    }

    private ExitCode run(StopRequest stop, String... options) {
        List<String> args = new ArrayList<>(List.of("run", "--scene=block", "--out=" + out));
        for (String option : options) {
            args.removeIf(arg -> arg.startsWith(option.replaceFirst("=.*", "=")));
            args.add(option);
        }
        screen = Screen.of(List.of(new RunCommand(scenes, stop), new ScenesCommand(scenes)), OptionStyle.GRADLE,
                args.toArray(String[]::new));
        return screen.code();
    }

    private void assertEnds(ExitCode code, String error, String... options) {
        run(options);
        assertEquals(new Screen(code, screen.out(), error), screen);
    }

    private Set<String> files() throws IOException {
        try (Stream<Path> files = Files.walk(out)) {
            return files.filter(Files::isRegularFile).map(file -> out.relativize(file).toString().replace('\\', '/'))
                    .filter(name -> !name.equals(".desolver-made")).collect(Collectors.toCollection(TreeSet::new));
        }
    }

    private byte[] trajectory() throws IOException {
        return Files.readAllBytes(out.resolve("trajectory.csv"));
    }

    private void replaceInScene(String old, String replacement) throws IOException {
        assertTrue(SCENE.contains(old), old);
        writeScene(SCENE.replace(old, replacement));
    }

    private void writeScene(String text) throws IOException {
        Files.writeString(scenes.resolve("01-block.yaml"), text);
    }

    private void assertPrinted(String... parts) {
        assertHas(screen.out(), parts);
    }

    private void assertJson(String... parts) throws IOException {
        assertHas(Files.readString(out.resolve("run.json")), parts);
    }

    private static final Set<String> NUMBERS_AND_PLOTS = Set.of("energy.png", "phase.png", "run.json",
            "trajectory.csv");

    /** Checks that there are numbers, plots and these files, and no others. */
    private void assertFiles(String... more) throws IOException {
        Set<String> expected = new TreeSet<>(NUMBERS_AND_PLOTS);
        expected.addAll(List.of(more));
        assertEquals(expected, files());
    }

    /** A million pictures are too many; a million seconds without pictures are not. */
    @Test
    void aLongRunIsRefusedOnlyForPicturesThatItDraws() throws IOException {
        Files.writeString(scenes.resolve("02-far.yaml"), """
                title: A long way
                teaches: Nothing but that it runs.
                solver: rk4
                deltaT: 1000
                duration: 1e6
                particles:
                  - {id: probe, position: [0, 0, 0], velocity: [1, 0, 0]}
                """);
        assertEquals(ExitCode.BAD_INPUT, run("--scene=2"));
        assertEquals(scenes.resolve("02-far.yaml") + """
                :5:11: a duration of 1000000 s needs more than a million pictures at frameRate = 25; give a lower \
                frameRate under 'output', or -Pframes=false for none""", screen.err());
        assertFalse(Files.exists(out), "nothing is written");
        assertEquals(ExitCode.DONE, run("--scene=2", "--frames=false"));
    }

    /** Bohr's electron: v = 2.18769e6 m/s at 5.2918e-11 m from the proton, k e^2/m = 253.27 m^3/s^2, T = 1.52e-16 s. */
    @Test
    void anAtomRunsInSiUnits() throws IOException {
        Files.writeString(scenes.resolve("02-atom.yaml"), """
                title: Hydrogen
                teaches: An electron circles a proton.
                solver: verlet
                deltaT: 1e-18
                duration: 1.52e-16
                particles:
                  - {id: proton, position: [0, 0, 0], mass: 1.6726e-27, fixed: true}
                  - {id: electron, position: [5.2918e-11, 0, 0], velocity: [0, 2.18769e6, 0], mass: 9.109e-31}
                effects:
                  - attraction: {centre: [0, 0, 0], strength: 253.27}
                look: {trail: 1e-16, velocityArrows: 1e-17}
                output: {frameRate: 5e16, width: 64, height: 48, phase: {particle: electron, axis: x}}
                """);
        assertEnds(ExitCode.DONE, "", "--scene=2");
        assertTrue(files().containsAll(Set.of("frames/frame-00007.png", "animation.gif")), files()::toString);
        String[] end = Files.readString(out.resolve("trajectory.csv")).strip().replaceFirst("(?s).*\n", "").split(",");
        assertEquals(5.2918e-11, Double.parseDouble(end[2]), 1.8e-15);   // back where it began; measured: 1.9e-16 m
        assertPrinted("energy: -2.18e-18 J at the start, -2.18e-18 J at the end");
    }

    @Test
    void aRunWritesItsFilesAndPrintsTheFolder() throws IOException {
        assertEnds(ExitCode.DONE, "");
        assertFiles("animation.gif", "frames/frame-00000.png", "frames/frame-00001.png", "frames/frame-00002.png",
                "frames/frame-00003.png", "frames/frame-00004.png", "frames/frame-00005.png");
        for (String name : files()) {
            if (name.endsWith(".png") || name.endsWith(".gif")) {
                assertTrue(ImageIO.read(out.resolve(name).toFile()).getWidth() >= 64, name);
            }
        }
        List<String> rows = Files.readAllLines(out.resolve("trajectory.csv"));
        assertEquals(1 + 51 * 2, rows.size());
        assertStarts(rows.get(102), "0.5,block,");
        assertPrinted("0.5 s simulated in 50 steps with 200 evaluations",
                "files in " + out + ": frames, animation.gif, energy.png, phase.png, trajectory.csv, run.json");
        assertJson("\"scene\" : \"01-block\"", "\"solver\" : \"rk4\"", "\"steps\" : 50",
                "\"evaluations\" : 200",
                "\"version\" : \"" + Program.VERSION + "\"", "\"endTime\" : 0.5");
    }

    @Test
    void aRunWithoutAPhasePlotSaysWhy() throws IOException {
        replaceInScene(", phase: {particle: block, axis: x}", "");
        assertEnds(ExitCode.DONE, "", "--frames=false");
        assertPrinted("energy.png, trajectory.csv, run.json",
                "no phase.png: under 'output', the scene names no particle for it");
        writeScene(SCENE);
        assertEnds(ExitCode.DONE, "", "--frames=false");
        assertFalse(screen.out().contains("no phase.png"), screen.out());
    }

    @Test
    void aFilmIsMadeOnRequest() throws IOException {
        assertEnds(ExitCode.DONE, "", "--video=mp4");
        assertTrue(files().containsAll(Set.of("film.mp4", "animation.gif")), files().toString());
        assertPrinted("animation.gif, film.mp4, energy.png");
        assertEnds(ExitCode.DONE, "");
        assertFalse(files().contains("film.mp4"), "the next run removes it");
        replaceInScene("{frameRate: 10", "{video: mp4, animation: false, frameRate: 10");
        assertEnds(ExitCode.DONE, "");
        assertTrue(files().contains("film.mp4") && !files().contains("animation.gif"), files().toString());
        assertEnds(ExitCode.DONE, "", "--video=none");
        assertFalse(files().contains("film.mp4"), "an option goes before the scene");
        assertEnds(ExitCode.DONE, "", "--frames=false");
        assertFiles();
    }

    /** Wider than an animation is otherwise, which would be 352 pixels wide. */
    @Test
    void framesAnimationAndFilmHaveTheSizeThatIsAskedFor() throws IOException {
        assertEnds(ExitCode.DONE, "", "--size=704x46", "--video=mp4", "--duration=0.1");
        for (String name : List.of("frames/frame-00001.png", "animation.gif")) {
            BufferedImage picture = ImageIO.read(out.resolve(name).toFile());
            assertEquals(List.of(704, 46), List.of(picture.getWidth(), picture.getHeight()), name);
        }
        // the film's track header ends with its size in 16.16 fixed point
        byte[] film = Files.readAllBytes(out.resolve("film.mp4"));
        int header = new String(film, StandardCharsets.ISO_8859_1).indexOf("tkhd") + 4 + 76;
        assertEquals(List.of(704, 46), List.of(ByteBuffer.wrap(film).getInt(header) >> 16,
                ByteBuffer.wrap(film).getInt(header + 4) >> 16));
    }

    @Test
    void theTrajectoryIsTheSameWithAndWithoutFramesAtAnyRate() throws IOException {
        run();
        byte[] first = trajectory();
        run();
        assertArrayEquals(first, trajectory());
        run("--frames=false");
        assertArrayEquals(first, trajectory());
        replaceInScene("frameRate: 10", "frameRate: 33.3");
        run();
        assertArrayEquals(first, trajectory());
        assertEquals(17, files().stream().filter(name -> name.startsWith("frames/")).count());
        run("--solver=verlet");
        assertFalse(java.util.Arrays.equals(first, trajectory()));
    }

    @Test
    void optionsOverrideTheScene() throws IOException {
        assertEnds(ExitCode.DONE, "", "--frames=false", "--solver=euler", "--deltaT=0.004", "--duration=0.01");
        assertJson("\"solver\" : \"euler\"", "\"deltaT\" : 0.004", "\"duration\" : 0.01",
                "\"steps\" : 3");
    }

    @Tag("slow")
    @Test
    void theTrajectoryIsThinnedByTheScenesKeyOrItsLength() throws IOException {
        replaceInScene("{frameRate: 10", "{trajectoryStride: 20, frameRate: 10");
        run("--frames=false");
        List<Double> thinned = times().stream().map(Double::valueOf).toList();
        assertEquals(4, thinned.size());
        assertEquals(0.4, thinned.get(2), 1e-14);               // the clock adds 0.01 forty times
        assertEquals(0.5, thinned.get(3));
        writeScene(SCENE);
        // 150,001 times of two particles: every second step
        run("--frames=false", "--deltaT=1e-6", "--duration=0.15");
        List<String> times = times();
        assertEquals(75_001, times.size());
        assertEquals("2.0E-6", times.get(1));
    }

    private List<String> times() throws IOException {
        try (Stream<String> rows = Files.lines(out.resolve("trajectory.csv"))) {
            return rows.skip(1).map(row -> row.substring(0, row.indexOf(','))).distinct().toList();
        }
    }

    /** What is typed, and the lines that refuse it. As an installed program, this has no libraries of the page. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            --deltat=1                    | unknown option -Pdeltat; did you mean -PdeltaT? allowed: -Pout, -Pscene, \
            -Psolver, -PdeltaT, -Pduration, -Pset, -Pthreads, -Pframes, -Pvideo, -Psize, -Preplay, -Pusd, -Pobj, \
            -Pslide, -Psvg, -Pdark, -Phelp
            --deltaT=soon                 | -PdeltaT: the value is the text 'soon'; it has to be a number over 0 (s)
            --deltaT=0,01                 | -PdeltaT: the value is the text '0,01'; a number has a decimal point, not \
            a comma; write 0.01
            --deltaT=0 --duration=long    | -PdeltaT: the value is 0; it has to be a number over 0 (s) // -Pduration: \
            the value is the text 'long'; it has to be a number from 0 up (s)
            --deltaT=1e-11                | SCENE:5:11: a duration of 0.5 s is 5e10 steps of deltaT = 1e-11 s; a run \
            can have at most 1e10
            --scnee=2 --scene=no-such-scene --deltaT=abc --solver=rk5 --threads=-1 --video=avi --out= \
            | unknown option -Pscnee; did you mean -Pscene? allowed: -Pout, -Pscene, -Psolver, -PdeltaT, -Pduration, \
            -Pset, -Pthreads, -Pframes, -Pvideo, -Psize, -Preplay, -Pusd, -Pobj, -Pslide, -Psvg, -Pdark, -Phelp \
            // -Psolver: unknown solver 'rk5'; did you mean 'rk4'? known: euler ... \
            // -PdeltaT: the value is the text 'abc'; it has to be a number over 0 (s) \
            // -Pthreads: the value is -1; it has to be a whole number from 1 to 64 \
            // there is no scene 'no-such-scene'; scenes: 01-block // option -Pout: needs a folder name \
            // option -Pvideo: 'avi' is not a kind of film; allowed: none, mp4
            --threads=0                   | -Pthreads: the value is 0; it has to be a whole number from 1 to 64
            --frames=maybe                | option -Pframes has to be true or false, not 'maybe'
            --out=                        | option -Pout: needs a folder name
            --solver=rk5                  | -Psolver: unknown solver 'rk5'; did you mean 'rk4'? known: euler ...
            --solver=my.Solver            | -Psolver: no class or solver is called 'my.Solver'; known solvers: euler ...
            --scene=blok                  | there is no scene 'blok'; did you mean 'block'? scenes: 01-block
            --size=wide                   | option -Psize: 'wide' is not a size such as 1920x1080
            --size=9999x100               | option -Psize: 9999 has to be from 16 to 4096
            --size=100x10                 | option -Psize: 10 has to be from 16 to 4096
            --size=100x100 --frames=false | -Psize needs pictures; remove -Pframes=false
            --video=avi                   | option -Pvideo: 'avi' is not a kind of film; allowed: none, mp4
            --video=mp4 --frames=false    | -Pvideo needs pictures; remove -Pframes=false
            --replay=true                 | option -Preplay: the page's libraries are not in this program; type: \
            gradle run -Preplay=true
            """)
    void wrongOptionsAreRefusedBeforeAnythingIsWritten(String typed, String expected) {
        assertEquals(ExitCode.BAD_INPUT, run(typed.split(" ")));
        assertEquals(expected.replace("SCENE", scenes.resolve("01-block.yaml").toString()).replace(" // ", "\n"),
                screen.err().replaceFirst(": euler,.*", ": euler ..."));
        assertFalse(Files.exists(out));
    }

    @Test
    void aBrokenSceneIsRefusedWithEveryPlace() throws IOException {
        writeScene(SCENE.replace("solver: rk4", "solvr: rk4").replace("mass: 2", "mass: -2"));
        assertEquals(ExitCode.BAD_INPUT, run());
        assertEquals(2, screen.err().lines().count(), screen.err());  // not also the missing key
        String place = scenes.resolve("01-block.yaml").toString().replace('\\', '/') + ":";
        assertTrue(screen.err().lines().allMatch(line -> line.startsWith(place)), screen.err());
        assertFalse(Files.exists(out));
    }

    @Test
    void anImpossibleFolderIsOneLineAndCode1() throws IOException {
        Files.writeString(out, "a file");
        assertEnds(ExitCode.TROUBLE, "cannot create the folder " + out + ": a file is where a folder should be");
        assertEnds(ExitCode.TROUBLE,
                "cannot create the folder " + out.resolve("below") + ": a file is where a folder should be",
                "--out=" + out.resolve("below"));
        assertEquals("a file", Files.readString(out));
    }

    @Test
    void aFileThatNoRunMadeIsNotOverwritten() throws IOException {
        Files.createDirectory(out);
        Files.writeString(out.resolve("energy.png"), "mine");
        assertEnds(ExitCode.TROUBLE, "cannot write " + out.resolve("energy.png")
                + ": this file exists and no run made it; move it away or choose another folder");
        assertEquals("mine", Files.readString(out.resolve("energy.png")));
    }

    /** omega h = 0.1: Euler multiplies the energy of 25 J by 1.01 in each step, up to 1000 times 100 N times 1.5 m. */
    @Test
    void aThousandfoldGainIsABlowUp() throws IOException {
        assertEquals(ExitCode.STOPPED, run("--solver=euler", "--duration=20", "--frames=false"));
        assertMatches(screen.err(), """
                euler stopped at t = 9\\.\\d+ s at particle 'block': the numerical error is \\d+ J, over 1000 times \
                the rest of the energy\\Rundamped springs gain energy with euler at any deltaT\\Rtry \
                -Psolver=verlet""");
    }

    /**
     * 343 particles on stiff springs that the impact makes buckle, far too long a step for them: implicit-midpoint is
     * stable, and its energy of 7 MJ in place of 20 J is not physics.
     */
    @Test
    @Tag("hard")
    void aMotionThatIsMostlyNumericalErrorEndsAsABlowUp() throws IOException {
        Path jelly = out.resolveSibling("jelly.yaml");
        Files.writeString(jelly, Files.readString(SceneFiles.find(Path.of("scenes"), "10"))
                .replaceAll("(columns|rows|layers): 6", "$1: 7").replaceAll("stiffness: \\d+", "stiffness: 60000"));
        assertEquals(ExitCode.STOPPED, run("--scene=" + jelly, "--solver=implicit-midpoint", "--deltaT=0.02",
                "--frames=false"));
        assertMatches(screen.err(), "implicit-midpoint stopped at t = [\\d.]+ s at particle 'jelly[^']*': the numerical"
                + " error is \\d+ J, over 1000 times the rest of the energy\\R"
                + "implicit-midpoint has no stability limit, but it adds energy where springs buckle or turn\\R"
                + "try -Psolver=linearised-euler, which solves one linear system per step and damps"
                + " what is too fast for it");
        assertFalse(screen.out().contains("warning"), "the lines above say it");
    }

    @Test
    void aBlowUpKeepsItsResultsAndEndsWithCode3() throws IOException {
        assertEquals(ExitCode.STOPPED, run("--deltaT=0.5", "--duration=100"));
        assertEquals(3, screen.err().lines().count(), screen.err());
        assertTrue(files().containsAll(NUMBERS_AND_PLOTS) && files().contains("frames/frame-00000.png"),
                files().toString());
        assertTrue(files().stream().noneMatch(name -> name.endsWith(".part")), files().toString());
        assertPrinted(" s of 100 s simulated in ");
        String end = times().get(times().size() - 1);
        assertJson("\"endTime\" : " + Digits.exact(Double.parseDouble(end)) + ",");
    }

    @Test
    void aRunThatIsStoppedKeepsWholeFilesAndEndsWithCode3() throws IOException {
        StopRequest stop = new StopRequest();
        stop.request();
        assertEquals(ExitCode.STOPPED, run(stop));
        assertEquals("the run was stopped at t = 0.01 s of 0.5 s", screen.err());
        assertFiles("animation.gif", "frames/frame-00000.png");
        assertEquals(List.of("0.0", "0.01"), times());
    }

    /** A student's solver that fails as a stop does. */
    public static final class Cancelling extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            throw new CancellationException("mine");
        }
    }

    @Test
    void anExceptionOfAStudentsSolverIsNoStop() {
        assertEquals(ExitCode.TROUBLE, run("--solver=" + Cancelling.class.getName(), "--frames=false"));
        assertHas(screen.err(), "CancellationException: mine", "stepState(RunCommandTest.java:");
    }

    @Test
    void scenesAreListedWithWhatTheyTeach() {
        assertEquals(List.of("01  block: A block (rk4)", "    Nothing but that it runs."), Screen.of(ExitCode.DONE,
                List.of(new ScenesCommand(scenes)), OptionStyle.SHELL, "scenes").lines().toList());
    }
}
