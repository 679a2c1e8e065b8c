package particles.output.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartPage;
import particles.output.charts.Panel;
import particles.output.charts.PanelGrid;
import particles.output.charts.SolverFamily;
import particles.view.ChartData;
import particles.view.VectorField;

/**
 * A picture of a page, and the chart data behind it.
 *
 * @param name     the name of its files, without an ending
 * @param caption  the caption
 * @param file     the name of the picture's file
 * @param title    the title over several panels
 * @param panels   the charts
 * @param drawn    the whole page instead of charts
 * @param slides   what is shown on slides instead, if it is not each panel by itself
 * @param repeated whether it shows a part of another one again, in a file of its own
 */
public record Picture(String name, String caption, String file, String title, List<Panel> panels,
        Optional<ChartPage> drawn, Optional<List<Picture>> slides, boolean repeated) {

    private Picture(String name, String caption, String title, List<Panel> panels) {
        this(name, caption, name + ".png", title, panels, Optional.empty(), Optional.empty(), false);
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param panel   the chart
     * @return a picture with one panel
     */
    public static Picture of(String name, String caption, Panel panel) {
        return new Picture(name, caption, panel.title(), List.of(panel));
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
        return of(name, caption, Panel.stacked(data));
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
        return new Picture(name, caption, title, panels);
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param title   the title over all panels
     * @param panels  the panels, row by row
     * @return a picture with many charts that have the same axes
     */
    public static Picture compared(String name, String caption, String title, List<Panel> panels) {
        return new Picture(name, caption, title, panels.stream().map(panel -> panel.scaledTo(panels)).toList());
    }

    /**
     * @param file    the file of a picture that is already in the folder
     * @param caption the caption
     * @return a picture that is not drawn again, such as an animation
     */
    public static Picture made(String file, String caption) {
        return new Picture(file.replaceFirst("[.].*", ""), caption, file, "", List.of(), Optional.empty(),
                Optional.empty(), false);
    }

    /**
     * @param name    the name of the picture's file, without an ending
     * @param caption the caption
     * @param page    the page, the same in all formats
     * @return a picture that is more than charts
     */
    public static Picture drawn(String name, String caption, ChartPage page) {
        return new Picture(name, caption, name + ".png", "", List.of(), Optional.of(page), Optional.empty(), false);
    }

    /** @return the picture, marked as a repetition of a part of a larger picture of the page */
    public Picture again() {
        return new Picture(name, caption, file, title, panels, drawn, slides, true);
    }

    /** @return the picture, replaced on slides by these, each of them without more than one panel */
    public Picture onSlides(List<Picture> others) {
        return new Picture(name, caption, file, title, panels, drawn, Optional.of(others), repeated);
    }

    List<ChartData> data() {
        return panels.stream().flatMap(panel -> panel.charts().stream()).toList();
    }

    /**
     * Splits a picture as the format needs: on slides each chart is a picture of its own; elsewhere only charts with
     * too many curves are split by solver families. The names of files say what is in them.
     *
     * @param format the format
     * @return the pictures to be drawn
     */
    public List<Picture> laidOut(ChartFormat format) {
        boolean crowded = panels.stream().anyMatch(panel -> panel.curves() > format.mostCurves());
        if (format.slide() && slides.isPresent()) {
            return slides.get().stream().flatMap(slide -> slide.laidOut(format).stream()).toList();
        }
        if (panels.isEmpty() || !crowded && !format.slide()) {
            return List.of(this);
        }
        Map<String, Picture> pictures = new LinkedHashMap<>();
        for (Panel panel : panels) {
            List<Panel> parts = panel.apart(!format.slide());
            for (Panel part : parts) {
                String file = name + (panels.size() == 1 ? "" : "-" + Panel.fileName(panel.title()))
                        + (part == parts.get(0) ? "" : "-" + part.quantity());
                String text = pictures.isEmpty() ? caption : heading(part) + ".";   // the first explains all
                Map<SolverFamily, Panel> families = part.byFamily();
                if (part.curves() <= format.mostCurves()) {
                    add(pictures, of(file, text, part.titled(heading(part))), panel);
                } else if (format.slide()) {
                    families.forEach((family, some) -> add(pictures, of(file + "-" + family.word(),
                            pictures.isEmpty() ? caption : heading(some) + ".", some.titled(heading(some))), panel));
                } else {
                    add(pictures, new Picture(file, text, heading(part), families.entrySet().stream().map(some ->
                            some.getValue().titled(some.getKey().title())).toList()), panel);
                }
            }
        }
        return List.copyOf(pictures.values());
    }

    /** Panels that show the same along another axis have its quantity in the name, too. */
    private static void add(Map<String, Picture> pictures, Picture picture, Panel panel) {
        String name = pictures.containsKey(picture.name()) ? picture.name() + "-"
                + Panel.fileName(panel.charts().get(0).xLabel()) : picture.name();
        pictures.put(name, new Picture(name, picture.caption(), picture.title(), picture.panels()));
    }

    /** The title of a panel; a chart without a title of its own shows its quantity. */
    private static String heading(Panel panel) {
        return panel.title().isEmpty() ? panel.charts().get(0).yLabel() : panel.title();
    }

    /** @return the page to be drawn; none if the picture is made elsewhere */
    public Optional<ChartPage> page(ChartFormat format) {
        return panels.isEmpty() ? drawn : Optional.of(panels.size() == 1
                ? ChartPage.of(panels.get(0), format) : new PanelGrid(title, panels).page());
    }
}
