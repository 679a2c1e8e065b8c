package particles.output.report;

import java.util.List;
import particles.output.charts.ChartFormat;
import particles.view.DataTable;

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

    /**
     * @param format what the pictures are for
     * @return the page with pictures that have no more curves than that allows, and no more charts
     */
    public ResultPage laidOut(ChartFormat format) {
        return new ResultPage(name, title, text,
                pictures.stream().flatMap(picture -> picture.laidOut(format).stream()).toList(), tables);
    }
}
