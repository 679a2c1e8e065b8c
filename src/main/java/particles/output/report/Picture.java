package particles.output.report;

import deSolvers.catalog.SolverInfo;
import deSolvers.catalog.SolverInfo.Group;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartPage;
import particles.output.charts.ChartWriter;
import particles.output.charts.PanelGrid;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;

/**
 * A picture of a page, and the chart data behind it.
 *
 * @param name     the name of its files, without an ending; of a picture made elsewhere, with it
 * @param caption  the caption
 * @param title    the title over several panels
 * @param panels   the charts, row by row; series of the same name share the legend
 * @param drawn    the whole page instead of charts
 * @param first    the solvers that a slide shows first, as it has at most five
 */
public record Picture(String name, String caption, String title, List<Panel> panels, Optional<ChartPage> drawn,
        List<String> first) {
    /** The largest number of solvers in one chart of a page. */
    private static final int CURVES = 6;
    private static final int CURVES_ON_A_SLIDE = 5;

    /**
     * The numbers at the ends of a chart's curves.
     *
     * @param quantity what they are of
     * @param curves   the curves, with their names and numbers
     */
    record Ends(String quantity, List<Series> curves) {
    }

    /** @return a picture with one panel */
    public static Picture of(String name, String caption, Panel panel) {
        return panels(name, caption, panel.title(), List.of(panel));
    }

    /** @return a picture with many panels */
    public static Picture panels(String name, String caption, String title, List<Panel> panels) {
        return new Picture(name, caption, title, panels, Optional.empty(), List.of());
    }

    /** @return a picture whose file is already in the folder, an animation */
    public static Picture made(String file, String caption) {
        return panels(file, caption, "", List.of());
    }

    /** @return a picture that is more than charts, the same in all formats */
    public static Picture drawn(String name, String caption, ChartPage page) {
        return new Picture(name, caption, "", List.of(), Optional.of(page), List.of());
    }

    /** @return the picture with the solvers that a slide shows first, if there are more than five */
    public Picture first(List<String> solvers) {
        return new Picture(name, caption, title, panels, drawn, solvers);
    }

    /** @return the name of the picture's file */
    public String file() {
        return isAnimation() ? name : name + ChartWriter.PNG;
    }

    boolean isAnimation() {
        return !hasData() && drawn.isEmpty();
    }

    boolean hasData() {
        return !panels.isEmpty();
    }

    /** @return the numbers at the ends of its curves */
    List<Ends> ends() {
        return panels.stream().flatMap(panel -> panel.charts().stream()).map(chart -> new Ends(chart.y().label(),
                chart.series().stream().filter(series -> !series.end().isEmpty()).toList()))
                .filter(ends -> !ends.curves().isEmpty()).toList();
    }

    /** @return the panels that have an answer */
    List<Panel> answers() {
        return panels.stream().filter(panel -> !panel.answer().isEmpty()).toList();
    }

    /**
     * Splits a picture as the format needs: on slides each chart is a picture of its own, with at most five curves;
     * elsewhere only charts with too many curves are split, a panel for each group of solvers.
     *
     * @param format the format
     * @return the pictures to be drawn
     */
    public List<Picture> laidOut(ChartFormat format) {
        if (!hasData() || !format.slide() && panels.stream().flatMap(panel -> panel.charts().stream())
                .allMatch(chart -> solvers(chart).size() <= CURVES)) {
            return List.of(this);
        }
        List<Picture> pictures = new ArrayList<>();
        for (Panel panel : panels) {
            for (List<Chart> part : panel.parts()) {
                Chart chart = part.get(0);
                pictures.add(panels(Stream.of(name, panel.name(), chart.name()).filter(word -> !word.isEmpty())
                        .collect(Collectors.joining("-")), pictures.isEmpty() ? caption : panel.title() + ": "
                        + chart.y().quantity() + ".", panel.title(), format.slide()
                        ? List.of(panel.with(panel.title(), List.of(onSlide(chart)))) : groups(panel, part)));
            }
        }
        return pictures;
    }

    private static Stream<SolverInfo> curves(Chart chart) {
        return chart.series().stream().filter(series -> series.mark().isCurve())
                .flatMap(series -> series.look().solver().stream());
    }

    private static List<String> solvers(Chart chart) {
        return curves(chart).map(SolverInfo::name).distinct().toList();
    }

    private Chart onSlide(Chart chart) {
        long own = chart.series().stream().filter(series -> series.mark().isCurve()
                && series.look().equals(Look.OWN)).count();
        List<String> solvers = solvers(chart);
        List<String> shown = Stream.concat(first.stream().filter(solvers::contains), solvers.stream()).distinct()
                .limit(Math.max(0, CURVES_ON_A_SLIDE - own)).toList();
        Chart some = chart.only(series -> series.look().solver().map(solver ->
                shown.contains(solver.name())).orElse(true));
        return chart.scale() == chart.series() ? some.scaledTo(some.series()) : some;
    }

    private static List<Panel> groups(Panel panel, List<Chart> charts) {
        List<Group> groups = curves(charts.get(0)).map(solver -> solver.family().group()).distinct().sorted()
                .toList();
        return groups.size() < 2 ? List.of(panel.with(panel.title(), charts)) : groups.stream().map(group ->
                panel.with(group.words, charts.stream().map(chart -> chart.only(series -> series.look().solver()
                        .map(solver -> solver.family().group() == group).orElse(true)))
                        .filter(chart -> !chart.series().isEmpty()).toList())).toList();
    }

    /** @return the page to be drawn; none if the picture is made elsewhere */
    public Optional<ChartPage> page(ChartFormat format) {
        return panels.isEmpty() ? drawn : Optional.of(panels.size() == 1
                ? ChartPage.of(panels.get(0), format) : PanelGrid.page(title, panels, format));
    }
}
