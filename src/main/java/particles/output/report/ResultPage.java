package particles.output.report;

import java.util.List;
import java.util.Optional;
import particles.output.charts.ChartWriter;
import particles.output.files.OutputFolder;
import particles.view.ChartData;
import particles.view.DataTable;
import particles.view.VectorField;

/**
 * What an experiment has to show: pictures, the numbers behind them, and what they say.
 *
 * @param name     of its task and folder, such as {@code workPrecision}
 * @param title    the finding, in a sentence
 * @param text     paragraphs that say what the pictures show
 * @param pictures the pictures
 * @param tables   the tables, the main one first
 */
public record ResultPage(String name, String title, List<String> text, List<Picture> pictures, List<DataTable> tables) {

    /** Writes a picture as a file. */
    private interface Drawing {
        void write(OutputFolder folder, String file);
    }

    /**
     * One panel of a picture with several.
     *
     * @param data  what it shows
     * @param phase whether that is a path in state space
     * @param field the arrows behind such a path, if there are any
     */
    public record Panel(ChartData data, boolean phase, Optional<VectorField> field) {
    }

    /** A picture, and the chart data behind it. */
    public static final class Picture {
        private final String name;
        private final String caption;
        private final String file;
        private final List<ChartData> data;
        private final Drawing drawing;

        private Picture(String name, String caption, String file, List<ChartData> data, Drawing drawing) {
            this.name = name;
            this.caption = caption;
            this.file = file;
            this.data = data;
            this.drawing = drawing;
        }

        /**
         * @param name    of the picture's files, without an ending
         * @param caption what it shows
         * @param data    the chart
         * @return a picture with one chart
         */
        public static Picture chart(String name, String caption, ChartData data) {
            return new Picture(name, caption, name + ".png", List.of(data), (folder, file) -> ChartWriter.write(folder,
                    file,
                    data));
        }

        /**
         * @param name    of the picture's files, without an ending
         * @param caption what it shows
         * @param data    a map of a plane
         * @return a picture with one chart, in which circles are round
         */
        public static Picture map(String name, String caption, ChartData data) {
            return new Picture(name, caption, name + ".png", List.of(data),
                    (folder, file) -> ChartWriter.writeMap(folder,
                    file, data));
        }

        /**
         * @param name    of the picture's files, without an ending
         * @param caption what it shows
         * @param data    the charts, the uppermost first
         * @return a picture with charts above each other over the same x axis
         */
        public static Picture stacked(String name, String caption, List<ChartData> data) {
            return new Picture(name, caption, name + ".png", data, (folder, file) -> ChartWriter.writeStacked(folder,
                    file,
                    data));
        }

        /**
         * @param name    of the picture's files, without an ending
         * @param caption what it shows
         * @param data    a path in state space
         * @param field   the arrows behind it, if there are any
         * @return a phase portrait
         */
        public static Picture phase(String name, String caption, ChartData data, Optional<VectorField> field) {
            return new Picture(name, caption, name + ".png", List.of(data),
                    (folder, file) -> ChartWriter.writePhase(folder, file, data, field));
        }

        /**
         * @param name    of the picture's files, without an ending
         * @param caption what it shows
         * @param title   over all panels
         * @param columns how many panels stand beside each other
         * @param panels  row by row; those with series of the same names share the legend
         * @return a picture with many charts
         */
        public static Picture panels(String name, String caption, String title, int columns, List<Panel> panels) {
            return new Picture(name, caption, name + ".png", panels.stream().map(Panel::data).toList(),
                    (folder, file) -> PanelWriter.write(folder, file, title, columns, panels));
        }

        /**
         * @param file    of a picture that is in the folder already
         * @param caption what it shows
         * @return a picture that is not drawn again, such as an animation
         */
        public static Picture made(String file, String caption) {
            return new Picture(file.replaceFirst("[.].*", ""), caption, file, List.of(), (folder, name) -> { });
        }

        String name() {
            return name;
        }

        String caption() {
            return caption;
        }

        String file() {
            return file;
        }

        List<ChartData> data() {
            return data;
        }

        void write(OutputFolder folder) {
            drawing.write(folder, file);
        }
    }
}
