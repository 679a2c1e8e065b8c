package particles.output.report;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * A report: several experiments on one page.
 *
 * @param title    the title of the page
 * @param text     the introduction, in paragraphs
 * @param sections the section of each experiment
 * @param end      the page's last line
 */
public record Report(String title, List<String> text, List<Section> sections, String end) {

    /**
     * One experiment; it has a page, or failed.
     *
     * @param task    the name of its task
     * @param purpose the purpose of the task, in a sentence
     * @param folder  the folder of its pictures
     * @param seconds its time (s)
     * @param page    its results
     * @param failure the reason if it has no results
     */
    public record Section(String task, String purpose, Path folder, double seconds, Optional<ResultPage> page,
                          Optional<String> failure) {
        /** A table with more rows is collapsed, and not printed. */
        private static final int MOST_ROWS = 60;

        String finding() {
            return page.map(ResultPage::title).orElse("could not be made");
        }

        List<TableView> tables() {
            return page.stream().flatMap(results -> results.tables().stream())
                    .map(table -> new TableView(table, MOST_ROWS)).toList();
        }
    }
}
