package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** What README tells people to type is there to be typed. */
class ReadmeTest {
    private static final Pattern GRADLE = Pattern.compile("\\bgradle ([a-z]\\w*)");
    private static final Pattern TASK = Pattern.compile("(?m)^(?:program '|task |junit5\\()(\\w+)");

    @Test
    void everyGradleCommandIsATask() throws IOException {
        Set<String> tasks = new TreeSet<>(Set.of("tasks", "installDist"));
        tasks.addAll(matches(TASK, Files.readString(Path.of("build.gradle"))));
        List<String> typed = matches(GRADLE, Files.readString(Path.of("README.md")));
        assertTrue(typed.contains("test"), "README tells how to test");
        typed.removeAll(tasks);
        assertEquals(List.of(), typed);
    }

    private static List<String> matches(Pattern pattern, String text) {
        List<String> found = new ArrayList<>();
        Matcher matcher = pattern.matcher(text);
        while (matcher.find()) {
            found.add(matcher.group(1));
        }
        return found;
    }
}
