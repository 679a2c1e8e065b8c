package particles.output.report;

import java.util.List;
import particles.output.charts.ChartFormat;
import particles.view.DataTable;

/**
 * The results of an experiment: pictures, the numbers behind them, and the findings.
 *
 * @param name     the name of its task and folder, such as {@code workPrecision}
 * @param title    the finding, in a sentence
 * @param text     paragraphs that explain the pictures
 * @param pictures the pictures
 * @param tables   the tables, the main one first
 */
public record ResultPage(String name, String title, List<String> text, List<Picture> pictures, List<DataTable> tables) {

    /**
     * @param format the format of the pictures
     * @return the page with pictures that have no more curves and charts than the format allows
     */
    public ResultPage laidOut(ChartFormat format) {
        return new ResultPage(name, title, text,
                pictures.stream().flatMap(picture -> picture.laidOut(format).stream()).toList(), tables);
    }
}
