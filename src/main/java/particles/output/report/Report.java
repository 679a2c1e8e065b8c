package particles.output.report;

import com.samskivert.mustache.Mustache;
import com.samskivert.mustache.Template.Fragment;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.report.TableText.TableView;

/**
 * A report: several experiments on one page.
 *
 * @param title    the title of the page
 * @param text     the introduction, in paragraphs
 * @param sections the section of each experiment
 * @param end      the page's last line
 */
public record Report(String title, List<String> text, List<Section> sections, String end) {
    private static final String PAGE = """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8"/>
            <meta name="viewport" content="width=device-width, initial-scale=1"/>
            <title>{{title}}</title>
            <style>
            {{{style}}}</style>
            </head>
            <body>
            <main>
            <h1>{{title}}</h1>
            {{#text}}
            <p>{{.}}</p>
            {{/text}}
            <nav>
            <h2>Contents</h2>
            <ol>
            {{#sections}}
            <li><a href="#{{task}}">{{task}}</a>: {{heading}}</li>
            {{/sections}}
            </ol>
            </nav>
            {{#sections}}
            <section id="{{task}}">
            <p class="task"><span class="command">gradle {{task}}</span>: {{purpose}}</p>
            <h2>{{heading}}</h2>
            {{#failure}}
            <p class="failure">{{.}}</p>
            {{/failure}}
            {{#page}}
            {{#text}}
            <p>{{.}}</p>
            {{/text}}
            {{#pictures}}
            <figure id="{{task}}-{{file}}"{{#isAnimation}} class="animation"{{/isAnimation}}>
            <img alt="{{caption}}" src="data:image/gif;base64,{{#bytes}}{{{folder}}}{{/bytes}}"/>
            <figcaption>{{caption}}</figcaption>
            {{#answers}}
            <p>{{title}}: {{answer}}</p>
            {{/answers}}
            {{#ends}}
            <div class="table"><table class="ends"><tbody>
            <tr><th scope="row" rowspan="2">{{quantity}}</th>{{#curves}}<th scope="col">{{name}}</th>{{/curves}}</tr>
            <tr>{{#curves}}<td class="number">{{end}}</td>{{/curves}}</tr>
            </tbody></table></div>
            {{/ends}}
            </figure>
            {{/pictures}}
            {{/page}}
            {{#tables}}
            <h3>{{table.title}}</h3>
            {{#long}}
            <details>
            <summary>All {{rows.size}} rows, also in {{table.name}}.csv</summary>
            {{/long}}
            <div class="table"><table id="{{task}}-{{table.name}}.csv">
            <thead><tr>{{#heads}}<th scope="col"{{#number}} class="number"{{/number}}>\
            <button type="button">{{text}}</button></th>{{/heads}}</tr></thead>
            <tbody>
            {{#rows}}
            <tr>{{#.}}{{#value}}<td class="number" data-value="{{.}}">{{text}}</td>{{/value}}\
            {{^value}}<td class="text">{{text}}</td>{{/value}}{{/.}}</tr>
            {{/rows}}
            </tbody>
            </table></div>
            {{#long}}
            </details>
            {{/long}}
            {{/tables}}
            </section>
            {{/sections}}
            </main>
            <footer><p>{{end}}</p></footer>
            <script>
            {{{script}}}</script>
            </body>
            </html>
            """;

    /**
     * One experiment; it has a page, or failed.
     *
     * @param task    the name of its task
     * @param purpose the purpose of the task, in a sentence
     * @param folder  the folder of its pictures
     * @param page    its results
     * @param failure the reason if it has no results
     */
    public record Section(String task, String purpose, Path folder, Optional<ResultPage> page,
                          Optional<String> failure) {
        /** A table with more rows is collapsed. */
        private static final int MOST_ROWS = 60;

        String heading() {
            return page.map(ResultPage::title).orElse("could not be made");
        }

        List<TableView> tables() {
            return page.stream().flatMap(results -> results.tables().stream())
                    .map(table -> new TableView(table, MOST_ROWS)).toList();
        }
    }

    /**
     * Writes the report as one self-contained HTML page, with pictures, style and script inside. The page is
     * well-formed XML too.
     *
     * @param folder the output folder
     * @param name   the name of its file, such as {@code report.html}
     * @throws OutputException if it cannot be written, or a picture cannot be read
     */
    public void write(OutputFolder folder, String name) {
        Mustache.Lambda bytes = Report::putBytes;
        try (OutputFile file = folder.create(name)) {
            Writer page = new OutputStreamWriter(file, StandardCharsets.UTF_8);     // the pictures may be large
            Html.TEMPLATES.compile(PAGE).execute(Map.of("title", title, "text", text, "end", end, "sections", sections,
                    "style", ReportStyle.CSS, "script", ReportStyle.SCRIPT, "bytes", bytes), page);
            page.flush();
            file.commit();
        } catch (IOException e) {
            throw new OutputException(folder.getPath().resolve(name), "write", e);
        }
    }

    /** Puts a picture in place of the folder that holds it, with 256 colours: a third of the size, and as clear. */
    private static void putBytes(Fragment folder, Writer page) {
        Picture picture = (Picture) folder.context();
        Path path = Path.of(folder.execute()).resolve(picture.file());
        try {
            ByteArrayOutputStream gif = new ByteArrayOutputStream();
            if (picture.isAnimation()) {
                Files.copy(path, gif);
            } else {
                ImageIO.write(ImageIO.read(path.toFile()), "gif", gif);
            }
            page.write(Base64.getEncoder().encodeToString(gif.toByteArray()));
        } catch (IOException e) {
            throw new OutputException(path, "read", e);
        }
    }
}
