package particles.output.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;

class ResultsIndexTest {
    @TempDir
    Path results;

    private void make(String folder, long time, String... files) throws IOException {
        make(results, folder, time, files);
    }

    private static void make(Path results, String folder, long time, String... files) throws IOException {
        try (OutputFolder made = OutputFolder.open(results.resolve(folder))) {
            for (String name : files) {
                try (OutputFile file = made.create(name)) {
                    file.write(new byte[] {1});
                    file.commit();
                }
            }
        }
        Files.setLastModifiedTime(results.resolve(folder), FileTime.fromMillis(time));
    }

    private List<String> found(String pattern) throws IOException {
        return found(results, pattern);
    }

    private static List<String> found(Path results, String pattern) throws IOException {
        return Pattern.compile(pattern).matcher(Files.readString(results.resolve(ResultsIndex.FILE))).results()
                .map((MatchResult match) -> match.group(1)).toList();
    }

    @Test
    void everyRunIsListedWithItsFirstPictureTheNewestFirst() throws IOException {
        make("old & gone", 1000, "drift.png", "drift.md");
        make("run", 3000, "animation.gif", "energy.png", "trajectory.csv");
        make("report", 2000, "report.html");
        make("report/race", 2000, "race.png");
        Files.setLastModifiedTime(results.resolve("report"), FileTime.fromMillis(2000));
        Files.createDirectories(results.resolve("mine"));
        Files.writeString(results.resolve("mine/photo.png"), "not made by a run");
        ResultsIndex.update(results);
        assertEquals(List.of("run", "report", "old &amp; gone"), found("<strong>(.*?)</strong>"));
        assertEquals(List.of("run/animation.gif", "report/race/race.png", "old%20&amp;%20gone/drift.png"),
                found("src=\"(.*?)\""));
        assertTrue(found("<a href=\"([^\"]*)\">[^<]").contains("report/report.html"));
    }

    /** On Windows, with drives and backslashes, the links are the same. */
    @Test
    void linksAreRelativeOnEverySystem() throws IOException {
        for (Configuration system : List.of(Configuration.windows(), Configuration.osX(), Configuration.unix())) {
            try (FileSystem disk = Jimfs.newFileSystem(system)) {
                Path out = Files.createDirectories(disk.getPath("build", "out"));
                make(out, "run größe", 3000, "energy.png");
                make(out, "report/race", 2000, "race.png");
                make(out, "report", 2000, "report.html");
                ResultsIndex.update(out);
                assertEquals(List.of("run%20gr%C3%B6%C3%9Fe/energy.png", "report/race/race.png"),
                        found(out, "src=\"(.*?)\""));
            }
        }
    }

    @Test
    void nothingIsWrittenWhereThereAreNoResults() throws IOException {
        ResultsIndex.update(results.resolve("nowhere"));
        ResultsIndex.update(results);
        assertFalse(Files.exists(results.resolve(ResultsIndex.FILE)));
        make("run", 1000, "a.png");
        ResultsIndex.update(results);
        make("later", System.currentTimeMillis() + 60_000, "b.png");
        ResultsIndex.update(results);
        assertEquals(List.of("later", "run"), found("<strong>(.*?)</strong>"));
    }

    /** With one temporary file for all, 23 of 600 updates failed. */
    @Test
    void twoProgramsMayWriteItAtOnce() throws IOException {
        make("run", System.currentTimeMillis() + 3_600_000, "a.png");
        IntStream.range(0, 600).parallel().forEach(n -> ResultsIndex.update(results));
        assertEquals(List.of("run"), found("<strong>(.*?)</strong>"));
    }
}
