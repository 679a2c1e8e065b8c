package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import particles.app.cli.OptionStyle;
import particles.scene.TestScenes;
import picocli.CommandLine;

class RaceCommandTest {
    private static double affordable(String scene, double deltaT, double duration) {
        return RaceCommand.affordable(TestScenes.named(scene).withDeltaT(deltaT).withDuration(duration));
    }

    /** 4170 numbers, 4 evaluations every 2 ms: 8.34e6 a second, and 1e7 are enough. */
    @Test
    void aClothRacesOverItsFirstPartAndSmallScenesToTheirEnd() {
        assertEquals(1.1, affordable("09-cloth-in-wind", 0.002, 8));
        assertEquals(0.11, affordable("09-cloth-in-wind", 0.0002, 8), "a tenth of the step, a tenth of the time");
        assertEquals(1.1, affordable("09-cloth-in-wind", 0.002, 1.1), "no more than that is left as it is");
        assertEquals(12, affordable("16-soft-chain", 0.04, 12));
    }

    @Test
    void whatIsLeftOutIsSaidBeforeAndADurationOfOnesOwnIsKept() {
        RaceCommand race = race("--scene=9");
        assertEquals(Optional.of("the race is over the first 1.1 s of this scene; -Pduration=8"
                + " races over all of it, which takes longer"), race.notice());
        assertEquals(Optional.empty(), race("--scene=9", "--duration=8").notice());
    }

    private static RaceCommand race(String... options) {
        RaceCommand race = new RaceCommand();
        new CommandLine(race).parseArgs(options);
        assertEquals(List.of(), race.mistakes(OptionStyle.GRADLE));
        return race;
    }
}
