package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static particles.Texts.assertStarts;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.ProgramCommand;
import particles.app.cli.Screen;
import particles.app.run.StopRequest;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** Invalid options of experiments are refused in one line, before any file is written. */
class ExperimentOptionsTest {
    @TempDir
    Path top;

    /** Where there are no charts, the options would do nothing; those of checkSolver are for its page only. */
    @Test
    void chartsOfRunsAndExperimentsMayBeSlidesAndSvg() {
        Set<String> expected = Set.of("run", "lectureFigures", "energyDrift", "workPrecision", "stiffGallery",
                "phasePlots", "stability", "effectCost", "stiffCloth", "race", "sweep", "report");
        for (ProgramCommand command : Main.commands(new StopRequest())) {
            CommandSpec spec = new CommandLine(command).getCommandSpec();
            for (String option : List.of("--slide", "--svg")) {
                assertEquals(expected.contains(spec.name()), spec.findOption(option) != null, spec.name() + option);
            }
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            phasePlots     | -Pset=output.phase.particle=blok | -Pset output.phase.particle: unknown particle 'blok'; \
            did you mean 'block'?
            phasePlots     | -Pset=output.phase.axis=w | -Pset output.phase.axis: unknown axis 'w'
            phasePlots     | -Psolvers=rk5       | option -Psolvers: unknown solver 'rk5'; did you mean 'rk4'?
            phasePlots     | -Pscene=27          | option -Pscene: at its start this scene has no free particle
            phasePlots     | -Pscenes=2         | unknown option -Pscenes; did you mean -Pscene?
            workPrecision  | -Pproblem=keplar    | option -Pproblem: no problem is called 'keplar'; did you mean \
            'kepler'?
            workPrecision  | '-Pproblem= ,'      | option -Pproblem: choose at least one problem
            workPrecision  | -Psolvers=no.Such   | option -Psolvers:
            stability      | -Pset=deltaT=1      | option -Pset: goes with -Pscene only
            stability      | -Pscene=1           | option -Pscene: this scene has no vibration or damping
            stiffGallery   | -Psolvers=euler,rk  | option -Psolvers: unknown solver 'rk'
            energyDrift    | -Pscene=sprng       | there is no scene 'sprng'
            energyDrift    | -Pset=duration=soon | -Pset duration:
            race           | -Pset=duration=0    | option -Pset: the duration is 0 s, and a race needs more
            energyDrift    | -Psolvers=rk4,rk4   | option -Psolvers: 'rk4' appears twice
            workPrecision  | -Pproblem=cloth,cloth | option -Pproblem: 'cloth' appears twice
            report         | -Pexperiments=race,race | option -Pexperiments: 'race' appears twice
            race           | -Psolvers=rk5       | option -Psolvers: unknown solver 'rk5'
            """)
    void invalidOptionsAreRefusedInOneLine(String command, String option, String line) {
        Path folder = top.resolve("results");
        Screen screen = Screen.of(Main.commands(new StopRequest()), OptionStyle.GRADLE, command,
                option.replaceFirst("-P", "--"), "--out=" + folder);
        assertEquals(new Screen(ExitCode.BAD_INPUT, "", screen.err()), screen);
        assertStarts(screen.err(), line);
        assertEquals(1, screen.err().lines().count(), screen.err());
        assertFalse(Files.exists(folder), "nothing is written");
    }
}
