package particles.output.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;

/** A page that lists all folders of results, the newest first, each with its first picture. */
public final class ResultsIndex {
    /** The name of the page, in the folder that holds the others. */
    public static final String FILE = "index.html";
    private static final String PAGE = """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8"/>
            <meta name="viewport" content="width=device-width, initial-scale=1"/>
            <title>Results</title>
            <style>
            body { margin: 0 auto; padding: 1rem; max-width: 76rem; font: 1rem/1.5 system-ui, sans-serif; }
            main { display: grid; grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); gap: 1.2rem; }
            figure { margin: 0; }
            img { width: 100%; height: 12rem; object-fit: contain; background: #f3f4f7; }
            figcaption { overflow-wrap: anywhere; }
            </style>
            </head>
            <body>
            <h1>Results</h1>
            <main>
            {{#entries}}
            <figure>{{#picture}}<a href="{{link}}"><img loading="lazy" alt="" src="{{link}}"/></a>{{/picture}}\
            <figcaption><strong>{{folder}}</strong>{{#pages}} <a href="{{link}}">{{file}}</a>{{/pages}}\
            </figcaption></figure>
            {{/entries}}
            </main>
            </body>
            </html>
            """;

    /** The results in a folder, and their time; its picture is a list of none or one. */
    private record Entry(String folder, FileTime made, List<Link> picture, List<Link> pages) {
    }

    private record Link(String file, String link) {
    }

    private ResultsIndex() {
    }

    /**
     * Writes the page, if there are results.
     *
     * @param results the folder that holds the folders of results
     * @throws OutputException if it cannot be written
     */
    public static void update(Path results) {
        Path page = results.resolve(FILE);
        try {
            List<Entry> entries = new ArrayList<>();
            for (Path folder : folders(results)) {
                List<Path> files = files(folder);
                if (!files.isEmpty()) {
                    entries.add(new Entry(folder.getFileName().toString(), Files.getLastModifiedTime(folder),
                            links(results, files.stream().filter(file -> has(file, ".gif", ".png")).limit(1)),
                            links(results, files.stream().filter(file -> file.getParent().equals(folder)
                                    && !has(file, ".csv", OutputFolder.FRAMES)))));
                }
            }
            if (entries.isEmpty()) {
                return;
            }
            entries.sort(Comparator.comparing(Entry::made).reversed().thenComparing(Entry::folder));
            Path part = Files.createTempFile(results, ".index", ".part");       // two programs may write at once
            Files.writeString(part, Html.fill(PAGE, Map.of("entries", entries)));
            Files.move(part, page, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw new OutputException(page, "write", e);
        }
    }

    /** Lists the files that the program made in a folder and, of a report, in the folders of its parts. */
    private static List<Path> files(Path folder) throws IOException {
        List<Path> files = new ArrayList<>();
        for (String name : OutputFolder.made(folder)) {
            files.add(folder.resolve(name));
        }
        if (!files.isEmpty()) {
            for (Path part : folders(folder)) {
                files.addAll(files(part));
            }
        }
        return files;
    }

    private static List<Path> folders(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(Files::isDirectory).sorted().toList();
        }
    }

    private static List<Link> links(Path results, Stream<Path> files) {
        return files.map(file -> new Link(file.getFileName().toString(),
                results.toUri().relativize(file.toUri()).toASCIIString())).toList();
    }

    private static boolean has(Path file, String... endings) {
        return Arrays.stream(endings).anyMatch(file.toString()::endsWith);
    }
}
