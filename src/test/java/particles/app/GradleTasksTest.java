package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import particles.app.cli.OptionStyle;
import particles.app.cli.ProgramCommand;
import particles.app.run.StopRequest;
import picocli.CommandLine.Command;

/** Commands and gradle tasks correspond one to one, with the same names and descriptions. */
class GradleTasksTest {
    private static final Pattern TASK = Pattern.compile("(?m)^program '([^']*)', '([^']*)'");

    @Test
    void everyCommandHasItsGradleTask() throws IOException {
        Map<String, String> tasks = new TreeMap<>();
        Matcher task = TASK.matcher(Files.readString(Path.of("build.gradle")));
        while (task.find()) {
            tasks.put(task.group(1), task.group(2));
        }
        Map<String, String> commands = new TreeMap<>();
        for (ProgramCommand command : Main.commands(new StopRequest())) {
            Command declared = command.getClass().getAnnotation(Command.class);
            commands.put(declared.name(), String.join(" ", declared.description()));
        }
        assertEquals(commands, tasks);
        tasks.values().forEach(sentence -> assertTrue(sentence.endsWith("."), sentence));
    }

    @Test
    void theBuildSetsTheStartedByProperty() throws IOException {
        String line = "systemProperty '" + OptionStyle.STARTED_BY + "', 'gradle'";
        assertTrue(Files.readString(Path.of("build.gradle")).contains(line), line);
    }
}
