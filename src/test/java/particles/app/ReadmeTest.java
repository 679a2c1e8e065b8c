package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.cli.ProgramCommand;
import particles.app.run.RunCommand;
import particles.app.run.StopRequest;
import picocli.CommandLine;

/** Tasks, options, tables and links in README exist. */
class ReadmeTest {
    private static final Pattern GRADLE = Pattern.compile("\\bgradle ([a-z]\\w*)");
    private static final Pattern TASK = Pattern.compile("(?m)^(?:program '|hunt '|task |junit5\\()(\\w+)");

    static final String README = read("README.md");
    private static final String BUILD = read("build.gradle");

    private static String read(String file) {
        try {
            return Files.readString(Path.of(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void everyGradleCommandIsATask() {
        Set<String> tasks = new TreeSet<>(Set.of("tasks", "installDist", "javadoc", "jar", "publishToMavenLocal"));
        tasks.addAll(matches(TASK, BUILD));
        List<String> typed = matches(GRADLE, README + read("scenes/README.md"));
        assertTrue(typed.contains("test") && typed.contains("run"), "README tells how to run and to test");
        typed.removeAll(tasks);
        assertEquals(List.of(), typed);
    }

    @Test
    void readmeIsShortAndFitsTheScreen() {
        assertTrue(README.lines().count() <= 300, README.lines().count() + " lines");
        assertEquals(List.of(), README.lines().filter(line -> line.length() > 120).toList());
    }

    @Test
    void linksLeadToFiles() {
        List<String> links = matches(Pattern.compile("\\]\\(([^)]*)\\)"), README);
        assertTrue(links.contains("scenes/README.md"), links.toString());
        assertEquals(List.of(), links.stream().filter(link -> !Files.exists(Path.of(link))).toList());
    }

    @Test
    void theOptionsOfRunAreThoseOfTheProgram() {
        RunCommand run = new RunCommand(Path.of("scenes"), new StopRequest());
        Set<String> options = new TreeSet<>();
        new CommandLine(run).getCommandSpec().options().stream().filter(option -> !option.usageHelp())
                .forEach(option -> options.add(OptionStyle.GRADLE.option(option.longestName())));
        assertEquals(options, new TreeSet<>(matches(Pattern.compile("(?m)^\\| `(-P\\w+)="), README)));
    }

    @Test
    void theExitCodesAreThoseOfTheProgram() {
        List<String> codes = List.of(ExitCode.values()).stream().map(code -> Integer.toString(code.code())).toList();
        assertEquals(codes, matches(Pattern.compile("(?m)^\\| (\\d) \\|"), README));
    }

    @Test
    void theSolversAreThoseOfTheCatalogue() {
        List<String> rows = new ArrayList<>();
        for (SolverInfo info : SolverCatalog.all()) {
            rows.add(String.join(" | ", "| `" + info.name() + "`", Integer.toString(info.order()), info.evaluations(),
                    limit(info.imaginaryLimit()), limit(info.dampedLimit()),
                    info.sentence() + " |"));
        }
        assertEquals(rows, README.lines().filter(line -> line.matches("\\| `[a-z0-9-]+` \\| \\d+ \\|.*")).toList());
    }

    private static String limit(double limit) {
        String number = limit == 0 ? "grows" : limit == Double.POSITIVE_INFINITY ? "unbounded" : Double.toString(limit);
        return Double.isNaN(limit) ? "-" : number.replaceFirst("\\.0$", "");
    }

    private static List<String> rowsOf(String section) {
        String text = README.substring(README.indexOf("\n## " + section + "\n") + 1);
        return text.substring(0, text.indexOf("\n## ", 3)).lines().filter(line -> line.startsWith("| `")).toList();
    }

    /** Each command has a task with its name and description, which README's table has, too; other tasks are hunts. */
    @Test
    void theTasksAreThoseOfTheBuildAndOfTheProgram() {
        List<String> tasks = matches(Pattern.compile("(?m)^program ('[^']*', '[^']*')"), BUILD);
        Set<String> commands = new TreeSet<>();
        for (ProgramCommand command : Main.commands(new StopRequest())) {
            String[] sentence = new CommandLine(command).getCommandSpec().usageMessage().description();
            commands.add("'" + command.name() + "', '" + String.join(" ", sentence) + "'");
        }
        assertEquals(commands, new TreeSet<>(tasks));
        tasks.forEach(task -> assertTrue(task.endsWith(".'"), task));
        assertEquals(matches(Pattern.compile("(?m)^(?:program|hunt) ('[^']*', '[^']*')"), BUILD).stream()
                .map(task -> task.replaceFirst("'(.*)', '(.*)'", "| `$1` | $2 |")).toList(), rowsOf("Tasks"));
    }

    @Test
    void theBuildHasTheVersionAndSetsTheStartedByProperty() {
        for (String line : List.of("version = '" + Program.VERSION + "'",
                "systemProperty '" + OptionStyle.STARTED_BY + "', 'gradle'")) {
            assertTrue(BUILD.contains(line), line);
        }
    }

    @Test
    void theClassesThatSlidesLeadToExist() throws ClassNotFoundException {
        List<String> names = matches(Pattern.compile("`((?:deSolvers|particles)\\.[a-zA-Z.]*[A-Z]\\w+)`"), README);
        assertTrue(names.size() > 12, names.toString());
        for (String name : names) {
            Class.forName(name);
        }
    }

    private static List<String> matches(Pattern pattern, String text) {
        return pattern.matcher(text).results().map(found -> found.group(1)).collect(Collectors.toList());
    }
}
