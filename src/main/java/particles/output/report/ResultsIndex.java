package particles.output.report;

import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
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
            figcaption { font-size: 0.9rem; overflow-wrap: anywhere; }
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

    /** The results in a folder: its files, the most interesting first, and their time. */
    @SuppressWarnings("UnusedMethod")                   // the page's template calls them
    private record Entry(String folder, List<String> files, FileTime made) {
        Optional<Link> picture() {
            return links(ResultsIndex::isPicture).findFirst();
        }

        List<Link> pages() {
            return links(file -> file.contains(".") && !file.contains("/") && !file.endsWith(".csv")).toList();
        }

        private Stream<Link> links(Predicate<String> which) {
            return files.stream().filter(which).map(file -> new Link(file, Arrays.stream((folder + "/" + file).split(
                    "/")).map(name -> URLEncoder.encode(name, StandardCharsets.UTF_8).replace("+", "%20"))
                    .collect(Collectors.joining("/"))));
        }
    }

    private record Link(String file, String link) {
    }

    private ResultsIndex() {
    }

    /**
     * Writes the page, unless there are no results that are newer.
     *
     * @param results the folder that holds the folders of results
     * @throws OutputException if it cannot be written
     */
    public static void update(Path results) {
        Path page = results.resolve(FILE);
        try {
            List<Entry> entries = entries(results);
            if (entries.isEmpty() || Files.exists(page)
                    && Files.getLastModifiedTime(page).compareTo(entries.get(0).made()) > 0) {
                return;
            }
            Path part = Files.createTempFile(results, ".index", ".part");       // two programs may write at once
            Files.writeString(part, Html.fill(PAGE, Map.of("entries", entries)));
            Files.move(part, page, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw new OutputException(page, "write", e);
        }
    }

    /** Lists the folders that the program made. */
    private static List<Entry> entries(Path results) throws IOException {
        if (!Files.isDirectory(results)) {
            return List.of();
        }
        List<Entry> entries = new ArrayList<>();
        for (Path folder : folders(results)) {
            List<String> files = new ArrayList<>(OutputFolder.made(folder));
            if (!files.isEmpty()) {
                for (Path part : folders(folder)) {             // of a report
                    OutputFolder.made(part).stream().filter(ResultsIndex::isPicture)
                            .forEach(file -> files.add(part.getFileName() + "/" + file));
                }
                entries.add(new Entry(folder.getFileName().toString(), files, Files.getLastModifiedTime(folder)));
            }
        }
        entries.sort(Comparator.comparing(Entry::made).reversed().thenComparing(Entry::folder));
        return entries;
    }

    private static List<Path> folders(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(Files::isDirectory).sorted().toList();
        }
    }

    private static boolean isPicture(String file) {
        return file.endsWith(".gif") || file.endsWith(".png");
    }

}
