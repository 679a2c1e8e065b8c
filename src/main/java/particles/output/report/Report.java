package particles.output.report;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Several experiments on one page.
 *
 * @param title    of the page
 * @param text     paragraphs that say what it is about
 * @param sections one an experiment
 * @param end      the page's last line
 */
public record Report(String title, List<String> text, List<Section> sections, String end) {

    /**
     * One experiment; it has a page, or failed.
     *
     * @param name    its task's
     * @param purpose what the task does, in a sentence
     * @param folder  where its pictures are
     * @param seconds that it took (s)
     * @param page    what it has to show
     * @param failure why it has nothing to show
     */
    public record Section(String name, String purpose, Path folder, double seconds, Optional<ResultPage> page,
                          Optional<String> failure) {
    }
}
