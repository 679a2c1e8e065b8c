package particles.output.report;

import com.samskivert.mustache.Mustache;
import com.samskivert.mustache.Template.Fragment;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Map;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;

/**
 * Writes a report as one self-contained HTML page, with pictures, style and script inside. The page is well-formed XML
 * too.
 */
public final class ReportWriter {
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
            <h1>{{title}}</h1>
            {{#text}}
            <p>{{.}}</p>
            {{/text}}
            <nav>
            <h2>Contents</h2>
            <ol>
            {{#sections}}
            <li><a href="#{{task}}">{{task}}</a>: {{finding}}</li>
            {{/sections}}
            </ol>
            </nav>
            {{#sections}}
            <section id="{{task}}">
            <p class="task">gradle {{task}}: {{purpose}}</p>
            <h2>{{finding}}</h2>
            {{#failure}}
            <p class="failure">{{.}}</p>
            {{/failure}}
            {{#page}}
            {{#text}}
            <p>{{.}}</p>
            {{/text}}
            {{#pictures}}
            {{^repeated}}
            <figure id="{{task}}-{{file}}"{{#look}} class="{{.}}"{{/look}}>
            <div class="scroll"><button type="button" title="larger or smaller"><img alt="{{caption}}" \
            src="data:image/{{type}};base64,{{#bytes}}{{{folder}}}{{/bytes}}"/></button></div>
            <figcaption>{{caption}}</figcaption>
            </figure>
            {{/repeated}}
            {{/pictures}}
            {{/page}}
            {{#tables}}
            {{#long}}
            <p class="printed">Not printed: {{table.title}}; {{rows.size}} rows, in {{table.name}}.csv.</p>
            <div class="folded">
            {{/long}}
            <h3>{{table.title}}</h3>
            {{#long}}
            <details>
            <summary>All {{rows.size}} rows</summary>
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
            </div>
            {{/long}}
            {{/tables}}
            </section>
            {{/sections}}
            <footer><p>{{end}}</p></footer>
            <script>
            {{{script}}}</script>
            </body>
            </html>
            """;

    private ReportWriter() {
    }

    /**
     * @param folder the output folder
     * @param name   the name of its file, such as {@code report.html}
     * @param report the report; the pictures are read from the sections' folders
     * @throws OutputException if it cannot be written, or a picture cannot be read
     */
    public static void write(OutputFolder folder, String name, Report report) {
        Mustache.Lambda bytes = ReportWriter::putBytes;
        try (OutputFile file = folder.create(name)) {
            Writer page = new OutputStreamWriter(file, StandardCharsets.UTF_8);     // the pictures may be large
            Html.TEMPLATES.compile(PAGE).execute(Map.of("title", report.title(), "text", report.text(), "end",
                    report.end(), "sections", report.sections(), "style", ReportStyle.CSS, "script",
                    ReportStyle.SCRIPT, "bytes", bytes), page);
            page.flush();
            file.commit();
        } catch (IOException e) {
            throw new OutputException(folder.getPath().resolve(name), "write", e);
        }
    }

    /** Puts a picture in place of the folder that holds it. */
    private static void putBytes(Fragment folder, Writer page) {
        Picture picture = (Picture) folder.context();
        Path path = Path.of(folder.execute()).resolve(picture.file());
        try {
            byte[] file = Files.readAllBytes(path);
            page.write(Base64.getEncoder().encodeToString(picture.data().isEmpty() ? file : SmallImage.of(file)));
        } catch (IOException e) {
            throw new OutputException(path, "read", e);
        }
    }
}
