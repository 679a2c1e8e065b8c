package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.app.run.StopRequest;

/**
 * Every command in README is run, by this test or through Gradle by {@code .ci/run}. A new command must be added to one
 * of the lists below or, if it takes long or writes among the sources, as a line {@code step gradle ...} to {@code
 * .ci/run}; use {@code refused gradle ...} for one that has to fail, and {@code shorter gradle ...} for one with extra
 * options that shorten it. A command that only names a scene by its number, or a solver, is run by this test for a
 * short duration and without pictures.
 */
class ReadmeCommandsTest {
    private static final String COMMAND = "gradle [a-z]\\w*(?: -P\\w+(?:=[^\\s`]+)?| '-P[^'`]*')*";
    private static final String SCENE = "gradle run(?: -Pscene=\\d+)?(?: -Psolver=[a-z0-9-]+)?";
    private static final Pattern IN_TEXT = Pattern.compile("`(" + COMMAND + ")`");
    private static final Pattern IN_BLOCK = Pattern.compile("(?m)^    (?:.*&& )?(" + COMMAND + ")$");
    private static final Pattern IN_CI = Pattern.compile("(?m)^(?:step|share|refused) (" + COMMAND + ")$");
    private static final Pattern SHORTER_IN_CI =
            Pattern.compile("(?m)^(?:shorter|share) (gradle [a-z]\\w*) (?:'?-P\\w+=[^'\\n]*'? ?)+$");

    private static final Pattern WORD = Pattern.compile("'[^']*'|\\S+");
    private static final Path README = Path.of("README.md");

    /** Less than a second each. */
    private static final Map<String, ExitCode> FAST = Map.of(
            "gradle scenes", ExitCode.DONE,
            "gradle solvers", ExitCode.DONE,
            "gradle exercise", ExitCode.DONE,
            "gradle gradeClass -Pfolder=submissions", ExitCode.BAD_INPUT,       // there is no such folder
            "gradle exercise -Pnumber=1 -Pstudent=ID", ExitCode.DONE,
            "gradle exercise -Pnumber=5 -Pstudent=ID", ExitCode.DONE,
            "gradle exercise -Pnumber=5 -Pstudent=ID -Panswer=3.42", ExitCode.BAD_INPUT,
            "gradle exercise -Pnumber=10 -Pstudent=ID '-Panswer=0.1 s'", ExitCode.BAD_INPUT);

    /** Some seconds each. */
    private static final Map<String, ExitCode> SLOW = Map.of(
            "gradle sweep -Pscene=3 '-Pvary=springs[0].damping = 0 .. 18 by 2'"
                    + " '-Pmeasure=min x of block, period x of block'",
            ExitCode.DONE,
            "gradle run -Pscene=11", ExitCode.DONE,
            "gradle run -Pscene=12 -PdeltaT=0.01", ExitCode.STOPPED,
            "gradle checkSolver -Psolver=midpoint", ExitCode.DONE);

    private static Set<String> commands(Path file, Pattern... patterns) throws IOException {
        String text = Files.readString(file);
        return Stream.of(patterns).flatMap(pattern -> pattern.matcher(text).results()).map(found -> found.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void everyCommandIsRunSomewhere() throws IOException {
        Set<String> typed = commands(README, IN_TEXT, IN_BLOCK);
        Set<String> run = commands(Path.of(".ci/run"), IN_CI, SHORTER_IN_CI);
        assertTrue(run.contains("gradle test") && run.contains("gradle run"), run.toString());
        run.addAll(FAST.keySet());
        run.addAll(SLOW.keySet());
        Set<String> neverRun = new TreeSet<>(typed);
        neverRun.removeAll(run);
        neverRun.removeAll(scenes());
        assertEquals(Set.of(), neverRun, "in README, and run neither by this test nor by .ci/run");
        Set<String> here = new TreeSet<>(FAST.keySet());
        here.addAll(SLOW.keySet());
        here.removeAll(typed);
        assertEquals(Set.of(), here, "run by this test, and not in README any more");
    }

    /** Every mention of a task counts as a command, so that none is overlooked because of its form. */
    @Test
    void noCommandIsOverlooked() throws IOException {
        String rest = Files.readString(README);
        for (String command : commands(README, IN_TEXT, IN_BLOCK)) {
            rest = rest.replaceAll(Pattern.quote(command) + "(?=`|\\n)", "");
        }
        assertEquals(List.of(), Pattern.compile("\\bgradle [a-z].*").matcher(rest).results()
                .map(MatchResult::group).toList());
    }

    @TestFactory
    Stream<DynamicTest> fastCommandsDoWhatTheyShould() {
        return tests(FAST);
    }

    private static Set<String> scenes() throws IOException {
        Set<String> scenes = commands(README, IN_TEXT, IN_BLOCK);
        scenes.removeIf(command -> !command.matches(SCENE) || SLOW.containsKey(command));
        return scenes;
    }

    @TestFactory
    Stream<DynamicTest> scenesRunForAShortWhile(@TempDir Path folder) throws IOException {
        Set<String> scenes = scenes();
        assertTrue(scenes.size() > 5, scenes.toString());
        return scenes.stream().map(command -> DynamicTest.dynamicTest(command,
                () -> run(command + " -Pframes=false -Pduration=0.01 -Pout=" + folder, ExitCode.DONE)));
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> slowCommandsDoWhatTheyShould() {
        return tests(SLOW);
    }

    private static Stream<DynamicTest> tests(Map<String, ExitCode> commands) {
        return commands.entrySet().stream().sorted(Map.Entry.comparingByKey())
                .map(entry -> DynamicTest.dynamicTest(entry.getKey(), () -> run(entry.getKey(), entry.getValue())));
    }

    private static void run(String command, ExitCode expected) {
        Screen.of(expected, Main.commands(new StopRequest()), OptionStyle.GRADLE,
                WORD.matcher(command).results().skip(1).map(word -> word.group().replace("'", "")
                        .replaceFirst("^-P", "--")).toArray(String[]::new));
    }
}
