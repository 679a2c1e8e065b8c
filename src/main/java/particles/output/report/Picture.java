package particles.output.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartPage;
import particles.output.charts.ChartWriter;
import particles.output.charts.Panel;
import particles.output.charts.PanelGrid;
import particles.output.charts.SolverStyle;
import particles.output.charts.SolverStyle.SolverFamily;
import particles.view.ChartData;

/**
 * A picture of a page, and the chart data behind it.
 *
 * @param name     the name of its files, without an ending; of a picture made elsewhere, with it
 * @param caption  the caption
 * @param title    the title over several panels
 * @param panels   the charts
 * @param bySolver makes the same charts of the solvers whose labels are chosen, to show many by families
 * @param drawn    the whole page instead of charts
 * @param slides   what is shown on slides instead, if it is not each panel by itself
 * @param repeated whether it shows a part of another one again, in a file of its own
 */
public record Picture(String name, String caption, String title, List<Panel> panels,
        Optional<Function<Predicate<String>, List<ChartData>>> bySolver, Optional<ChartPage> drawn,
        Optional<List<Picture>> slides, boolean repeated) {

    private Picture(String name, String caption, String title, List<Panel> panels, Optional<ChartPage> drawn) {
        this(name, caption, title, panels, Optional.empty(), drawn, Optional.empty(), false);
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param panel   the chart, or charts above each other
     * @return a picture with one panel
     */
    public static Picture of(String name, String caption, Panel panel) {
        return panels(name, caption, panel.title(), List.of(panel));
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param results the result of each solver
     * @param label   the label of a result's solver
     * @param charts  makes charts of results above each other over the same x axis, the uppermost first
     * @return a picture that shows solvers by families where they are too many for one panel
     */
    public static <T> Picture bySolver(String name, String caption, List<T> results, Function<T, String> label,
            Function<List<T>, List<ChartData>> charts) {
        Panel all = Panel.stacked(charts.apply(results));
        return new Picture(name, caption, all.title(), List.of(all), Optional.of(which -> charts.apply(results.stream()
                .filter(result -> which.test(label.apply(result))).toList())), Optional.empty(), Optional.empty(),
                false);
    }

    /**
     * @param name    the name of the picture's files, without an ending
     * @param caption the caption
     * @param title   the title over all panels
     * @param panels  row by row; those with series of the same names share the legend
     * @return a picture with many charts
     */
    public static Picture panels(String name, String caption, String title, List<Panel> panels) {
        return new Picture(name, caption, title, panels, Optional.empty());
    }

    /**
     * @param file    the file of a picture that is already in the folder
     * @param caption the caption
     * @return a picture that is not drawn again, such as an animation
     */
    public static Picture made(String file, String caption) {
        return new Picture(file, caption, "", List.of(), Optional.empty());
    }

    /**
     * @param name    the name of the picture's file, without an ending
     * @param caption the caption
     * @param page    the page, the same in all formats
     * @return a picture that is more than charts
     */
    public static Picture drawn(String name, String caption, ChartPage page) {
        return new Picture(name, caption, "", List.of(), Optional.of(page));
    }

    /** @return the picture, marked as a repetition of a part of a larger picture of the page */
    public Picture again() {
        return new Picture(name, caption, title, panels, bySolver, drawn, slides, true);
    }

    /** @return the picture, replaced on slides by these, each of them without more than one panel */
    public Picture onSlides(List<Picture> others) {
        return new Picture(name, caption, title, panels, bySolver, drawn, Optional.of(others), repeated);
    }

    /** @return the name of the picture's file */
    public String file() {
        return panels.isEmpty() && drawn.isEmpty() ? name : name + ChartWriter.PNG;
    }

    /** @return its look on a page: as any chart, or as one that moves, or that has many parts */
    Optional<String> look() {
        return type().equals("gif") ? Optional.of("animation")
                : panels.size() > 1 ? Optional.of("whole") : Optional.empty();
    }

    /** @return the type of its file, png or gif */
    String type() {
        return file().substring(file().lastIndexOf('.') + 1);
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
        if (format.slide() && slides.isPresent()) {
            return slides.get().stream().flatMap(slide -> slide.laidOut(format).stream()).toList();
        }
        if (panels.isEmpty() || !format.slide() && panels.stream().noneMatch(panel -> isCrowded(panel, format))) {
            return List.of(this);
        }
        Map<String, Picture> pictures = new LinkedHashMap<>();
        for (Panel panel : panels) {
            List<Panel> parts = panel.apart(!format.slide());
            for (Panel part : parts) {
                String file = name + (panels.size() == 1 ? "" : "-" + Panel.fileName(panel.title()))
                        + (part == parts.get(0) ? "" : "-" + part.quantity());
                if (!isCrowded(part, format)) {
                    add(pictures, file, part, List.of(part.titled(heading(part))));
                } else if (!format.slide()) {
                    add(pictures, file, part, part.families().stream().map(family ->
                            member(part, family, true).titled(title(family))).toList());
                } else {
                    for (SolverFamily family : part.families()) {
                        Panel some = member(part, family, false);
                        // a finding such as 'rk4 is cheapest' holds among these solvers
                        String whose = " (" + title(family) + ")";
                        String title = heading(some);
                        Panel named = some.titled(title.contains(": ") ? title.replaceFirst(": ", whose + ": ")
                                : title + whose);
                        add(pictures, file + "-" + family.word(), named, List.of(named));
                    }
                }
            }
        }
        return List.copyOf(pictures.values());
    }

    private boolean isCrowded(Panel panel, ChartFormat format) {
        return bySolver.isPresent() && panel.curves() > format.mostCurves();
    }

    @SuppressWarnings("ReturnValueIgnored")             // the filter is called for the labels that it is asked about
    private String title(SolverFamily family) {
        boolean[] own = new boolean[1];
        bySolver.orElseThrow().apply(label -> {
            own[0] |= SolverStyle.of(label).isEmpty();
            return true;
        });
        return family.title + (own[0] ? " and your own" : "");
    }

    /** @return the panel with the solvers of one family, and one's own, on the same axes */
    private Panel member(Panel part, SolverFamily family, boolean rows) {
        return Panel.stacked(bySolver.orElseThrow().apply(label -> SolverStyle.of(label)
                .map(look -> look.family() == family).orElse(true))).apart(rows).stream()
                .filter(some -> quantity(some).equals(quantity(part))).findFirst().orElseThrow()
                .scaledTo(List.of(part));
    }

    /**
     * Adds a picture of a panel, or of its parts. The first one's caption explains all. Panels that show the same along
     * another axis have its quantity in the name, too.
     */
    private void add(Map<String, Picture> pictures, String file, Panel whole, List<Panel> parts) {
        String unique = pictures.containsKey(file) ? file + "-" + Panel.fileName(whole.charts().get(0).xLabel()) : file;
        String text = pictures.isEmpty() ? caption : heading(whole) + ".";
        pictures.put(unique, panels(unique, text, heading(whole), parts));
    }

    private static String quantity(Panel panel) {
        return panel.charts().get(0).yLabel();
    }

    /** The title of a panel; a chart without a title of its own shows its quantity. */
    private static String heading(Panel panel) {
        return panel.title().isEmpty() ? quantity(panel) : panel.title();
    }

    /** @return the page to be drawn; none if the picture is made elsewhere */
    public Optional<ChartPage> page(ChartFormat format) {
        return panels.isEmpty() ? drawn : Optional.of(panels.size() == 1
                ? ChartPage.of(panels.get(0), format) : new PanelGrid(title, panels).page());
    }
}
