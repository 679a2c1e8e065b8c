package particles.output.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartWriter;
import particles.output.charts.Panel;
import particles.output.charts.PanelGrid;
import particles.view.ChartData;
import particles.view.VectorField;

/**
 * A picture of a page, and the chart data behind it.
 *
 * @param name     the name of its files, without an ending
 * @param caption  the caption
 * @param file     the name of the picture's file
 * @param title    the title over several panels
 * @param oneScale whether all panels have the same axes
 * @param panels   the charts; none if the picture is made elsewhere
 * @param repeated whether it shows a part of another one again, in a file of its own
 */
public record Picture(String name, String caption, String file, String title, boolean oneScale, List<Panel> panels,
        boolean repeated) {

    private Picture(String name, String caption, String title, boolean oneScale, List<Panel> panels) {
        this(name, caption, name + ".png", title, oneScale, panels, false);
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param panel   the chart
     * @return a picture with one panel
     */
    public static Picture of(String name, String caption, Panel panel) {
        return new Picture(name, caption, panel.title(), false, List.of(panel));
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param data    the chart
     * @return a picture with one chart
     */
    public static Picture chart(String name, String caption, ChartData data) {
        return of(name, caption, Panel.chart(data));
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param data    the charts, the uppermost first
     * @return a picture with charts above each other over the same x axis
     */
    public static Picture stacked(String name, String caption, List<ChartData> data) {
        return of(name, caption, new Panel(data, Panel.Kind.CHART, Optional.empty()));
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param data    a path in state space
     * @param field   the arrows behind it, if there are any
     * @return a phase portrait
     */
    public static Picture phase(String name, String caption, ChartData data, Optional<VectorField> field) {
        return of(name, caption, Panel.phase(data, field));
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param title   the title over all panels
     * @param panels  row by row; those with series of the same names share the legend
     * @return a picture with many charts, each with its own scale
     */
    public static Picture panels(String name, String caption, String title, List<Panel> panels) {
        return new Picture(name, caption, title, false, panels);
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param title   the title over all panels
     * @param panels  the panels, row by row
     * @return a picture with many charts that have the same axes
     */
    public static Picture compared(String name, String caption, String title, List<Panel> panels) {
        return new Picture(name, caption, title, true, panels);
    }

    /**
     * @param file    the file of a picture that is already in the folder
     * @param caption the caption
     * @return a picture that is not drawn again, such as an animation
     */
    public static Picture made(String file, String caption) {
        return new Picture(file.replaceFirst("[.].*", ""), caption, file, "", false, List.of(), false);
    }

    /** @return the picture, marked as a repetition of a part of a larger picture of the page */
    public Picture again() {
        return new Picture(name, caption, file, title, oneScale, panels, true);
    }

    List<ChartData> data() {
        return panels.stream().flatMap(panel -> panel.charts().stream()).toList();
    }

    /**
     * Splits a picture as the format needs: on slides each chart is a picture of its own; elsewhere only charts with
     * too many curves are split by solver families.
     */
    List<Picture> laidOut(ChartFormat format) {
        boolean crowded = panels.stream().anyMatch(panel -> panel.curves() > format.mostCurves());
        if (repeated && format.slide()) {
            return List.of();                           // the larger picture is slides
        }
        if (panels.isEmpty() || !crowded && !format.slide()) {
            return List.of(this);
        }
        List<Picture> pictures = new ArrayList<>();
        for (Panel part : panels.stream().flatMap(panel -> panel.apart().stream()).toList()) {
            List<Panel> families = part.curves() > format.mostCurves() ? part.byFamily() : List.of(part);
            if (!format.slide()) {
                pictures.add(new Picture(next(pictures), captionOf(part, pictures), heading(part), true, families));
            } else {
                families.forEach(family ->
                        pictures.add(of(next(pictures), captionOf(part, pictures), family.named())));
            }
        }
        return pictures;
    }

    /** The caption explains all parts and stands below the first one; each other part has its heading. */
    private String captionOf(Panel part, List<Picture> before) {
        return before.isEmpty() ? caption : heading(part) + ".";
    }

    private String next(List<Picture> before) {
        return before.isEmpty() ? name : name + "-" + (before.size() + 1);
    }

    /** The title of a panel; a chart without a title of its own shows its quantity. */
    private static String heading(Panel panel) {
        return panel.title().isEmpty() ? panel.charts().get(0).yLabel() : panel.title();
    }

    void write(ChartWriter writer) {
        if (panels.size() == 1) {
            writer.write(file, panels.get(0));
        } else if (!panels.isEmpty()) {
            new PanelGrid(title, panels, oneScale).write(writer, file);
        }
    }
}
