package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static particles.Texts.assertStarts;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.app.run.StopRequest;

/** A wrong value for a key of a scene, a wrong range or a wrong measure is refused in one line, before any run. */
class SweepOptionsTest {
    @TempDir
    Path top;

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            springs[0].dampng=1              | -Pset springs[0].dampng: unknown key 'dampng'; did you mean 'damping'?
            spring[0].damping=1              | -Pset spring[0].damping: there is no list for [0]
            sprigns=1                        | -Pset sprigns: unknown key 'sprigns'; did you mean 'springs'?
            springs[1].damping=1             | -Pset springs[1].damping: [1] does not exist; the last one is [0]
            springs[0].damping=-1            | -Pset springs[0].damping: 'damping' is -1; it has to be a number from 0
            springs[0].damping=1,5           | -Pset: '5' has to be KEY = VALUE
            springs[0].damping='2'           | -Pset springs[0].damping: 'damping' is the text '2'; a number has no \
            quotes
            springs[0].damping=              | -Pset springs[0].damping: a value is missing
            springs[0].damping               | -Pset: 'springs[0].damping' has to be KEY = VALUE
            springs.damping=1                | -Pset springs.damping: the entries of this list have no names
            springs[-1].damping=1            | -Pset: 'springs[-1].damping' is not a key such as
            springs[0].damping.x=1           | -Pset springs[0].damping.x: it is a number from 0 up (N s/m), and has no
            particles.blok.mass=2            | -Pset particles.blok.mass: unknown entry 'blok'; did you mean 'block'?
            particles.block.mass=0           | -Pset particles.block.mass: 'mass' is 0; it has to be a number over 0
            particles.block.position=[1, 2]  | -Pset particles.block.position: 'position' has 2 entries
            effects.gravty.acceleration=1    | -Pset effects.gravty.acceleration: unknown effect 'gravty'; did you mean
            effects.gravity.acceleration=9.81 | -Pset effects.gravity.acceleration: 'acceleration' is 9.81; it has to
            rules.gravity.acceleration=1     | -Pset rules.gravity.acceleration: 'gravity' is an effect, not a rule
            deltaT=0                         | -Pset deltaT: 'deltaT' is 0; it has to be a number over 0 (s)
            deltaT=[1                        | -Pset deltaT:1:3: not valid YAML
            deltaT=1e-12                     | scenes/03-damped-spring.yaml:11:11: a duration of 5 s is 5e12 steps
            solver=rk5                       | -Pset solver: unknown solver 'rk5'; did you mean 'rk4'?
            solver.relativeTolerance=1e-6    | -Pset solver.relativeTolerance: solver 'rk4' takes steps of deltaT
            title.length=3                   | -Pset title.length: it is a text
            """)
    void wrongValuesAreReportedLikeThoseOfAFile(String set, String line) {
        refused(line, "run", "--scene=3", "--frames=false", "--set=" + set);
        refused(line, "sweep", "--scene=3", "--vary=duration=1", "--measure=steps", "--set=" + set);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            springs[0].dampng = 1, 2         | -Pvary springs[0].dampng: unknown key 'dampng'; did you mean 'damping'?
            springs[0].damping = 1, -2       | -Pvary springs[0].damping: 'damping' is -2; it has to be a number from 0
            springs[0].damping = 0 .. 5      | option -Pvary: '0 .. 5' is not a range such as 0 .. 40 by 5
            springs[0].damping = 0..5 by     | option -Pvary: '0..5 by' is not a range such as
            springs[0].damping = 0 .. x by 1 | option -Pvary: 'x' is not a number
            springs[0].damping = 0 .. 8 by 1d | option -Pvary: '1d' is not a number
            springs[0].damping = 0x1p0 .. 8 by 1 | option -Pvary: '0x1p0' is not a number
            springs[0].damping = 0 .. 8 by NaN | option -Pvary: 'NaN' is not a number
            springs[0].damping = 0 .. 5 by 0 | option -Pvary: in '0 .. 5 by 0' the step does not lead to the last value
            springs[0].damping = 5 .. 0 by 1 | option -Pvary: in '5 .. 0 by 1' the step does not lead to the last value
            springs[0].damping = 0 .. 5 log 3 | option -Pvary: a logarithmic range needs two different ends
            springs[0].damping = 1 .. 5 log 1 | option -Pvary: in '1 .. 5 log 1', log has to be followed by the number
            springs[0].damping = 1 .. 5 log 2.5 | option -Pvary: in '1 .. 5 log 2.5', log has to be followed by the
            springs[0].damping = 0.001 .. 0.0010001 log 100 | option -Pvary: '0.001 .. 0.0010001 log 100' has too \
            many values: with the digits shown, some are equal
            springs[0].damping = 0 .. 1 by 1e-9 | option -Pvary: '0 .. 1 by 1e-9' has too many values
            springs[0].damping = 0 .. 1e999999999 by 1 | option -Pvary: '1e999999999' is too large
            springs[0].damping = 1, 1        | option -Pvary: a value of 'springs[0].damping' appears twice
            springs[0].damping = 1,, 2       | option -Pvary: a value of 'springs[0].damping' is empty
            springs[0].damping =             | option -Pvary: 'springs[0].damping =' has to be KEY = VALUE, VALUE ...
            rk4, verlet                      | option -Pvary: 'rk4, verlet' has to be KEY = VALUE, VALUE ...
            deltaT = 0.1; deltaT = 0.2       | option -Pvary: an axis appears twice
            deltaT=1; duration=1; solver=rk4; impact=exact | option -Pvary: 4 axes are too many; at most 3
            deltaT=0 .. 1 by 1e-4; duration=0 .. 1 by 1e-3 | option -Pvary: that is 10011001 runs; at most 1000000
            solver = rk4, rk5                | -Pvary solver: unknown solver 'rk5'; did you mean 'rk4'?
            """)
    void wrongAxesAreRefused(String vary, String line) {
        refused(line, "sweep", "--scene=3", "--vary=" + vary, "--measure=steps");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            energy lots         | option -Pmeasure: unknown measure 'energy lots'; did you mean 'energy lost'?
            max x of blok       | option -Pmeasure: unknown particle 'blok'; did you mean 'block'?
            most x of block     | option -Pmeasure: unknown measure 'most x of block'
            amplitude vx of block | option -Pmeasure: amplitude is that of x, y or z
            work of spring      | option -Pmeasure: unknown force 'spring'; did you mean 'springs'?
            ,                   | option -Pmeasure: a measure is empty
            steps,, drift       | option -Pmeasure: a measure is empty
            steps, steps        | option -Pmeasure: 'steps' appears twice
            """)
    void wrongMeasuresAreRefused(String measure, String line) {
        refused(line, "sweep", "--scene=3", "--vary=deltaT = 0.01, 0.02", "--measure=" + measure);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --part=3/2               | option -Ppart: has to be a part of the points, such as 3/16
            --part=1                 | option -Ppart: has to be a part of the points, such as 3/16
            --collect=no-such-folder | option -Pcollect: 'no-such-folder' is not a folder
            """)
    void wrongPartsAreRefused(String option, String line) {
        refused(line, "sweep", "--scene=3", "--vary=deltaT = 0.01, 0.02", "--measure=steps", option);
    }

    @Test
    void aSweepNeedsAScene() {
        refused("option -Pscene: names the scene to run", "sweep", "--vary=deltaT=1", "--measure=steps");
    }

    private void refused(String line, String command, String... options) {
        Path folder = top.resolve("results");
        String[] all = new String[options.length + 2];
        all[0] = command;
        System.arraycopy(options, 0, all, 1, options.length);
        all[options.length + 1] = "--out=" + folder;
        Screen screen = Screen.of(Main.commands(new StopRequest()), OptionStyle.GRADLE, all);
        assertEquals(new Screen(ExitCode.BAD_INPUT, "", screen.err()), screen);
        assertStarts(screen.err(), line);
        assertEquals(1, screen.err().lines().count(), screen.err());
        assertFalse(Files.exists(folder), "nothing is written");
    }
}
