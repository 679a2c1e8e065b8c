package particles.output.report;

import deSolvers.catalog.SolverInfo;
import deSolvers.catalog.SolverInfo.Group;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
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
 * @param name    the name of its files, without an ending; of a picture made elsewhere, with it
 * @param caption the caption
 * @param title   the title over several panels
 * @param panels  the charts, row by row; series of the same name share the legend
 * @param drawn   the whole page instead of charts
 * @param first   the solvers that a slide shows first, as it has at most five
 * @param role    whether it repeats a part of another one, or leaves it to others
 */
public record Picture(String name, String caption, String title, List<Panel> panels, Optional<ChartPage> drawn,
        List<String> first, Role role) {
    /** The largest number of solvers in one chart of a page. */
    private static final int CURVES = 6;
    private static final int CURVES_ON_A_SLIDE = 5;

    /** What a picture is for. */
    public enum Role {
        /** It is shown wherever pictures are. */
        ANYWHERE,
        /** It shows a part of a larger picture of the page again, in a file of its own. */
        REPEATS,
        /** Its parts are pictures too, so it is no slide. */
        WHOLE,
    }

    /**
     * The numbers at the ends of a chart's curves.
     *
     * @param quantity what they are of
     * @param curves   the curves, with their names and numbers
     */
    record Ends(String quantity, List<Series> curves) {
    }

    private Picture(String name, String caption, String title, List<Panel> panels, Optional<ChartPage> drawn) {
        this(name, caption, title, panels, drawn, List.of(), Role.ANYWHERE);
    }

    /** @return a picture with one panel */
    public static Picture of(String name, String caption, Panel panel) {
        return panels(name, caption, panel.title(), List.of(panel));
    }

    /** @return a picture with many panels */
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

    /** @return a picture that is more than charts, the same in all formats */
    public static Picture drawn(String name, String caption, ChartPage page) {
        return new Picture(name, caption, "", List.of(), Optional.of(page));
    }

    /** @return the picture in another role */
    public Picture as(Role other) {
        return new Picture(name, caption, title, panels, drawn, first, other);
    }

    /** @return the picture with the solvers that a slide shows first, if there are more than five */
    public Picture first(List<String> solvers) {
        return new Picture(name, caption, title, panels, drawn, solvers, role);
    }

    /** @return whether a page shows it as a part of another picture */
    boolean isRepeated() {
        return role == Role.REPEATS;
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

    /** @return whether there are charts on it */
    boolean hasData() {
        return !panels.isEmpty();
    }

    /** @return the numbers at the ends of its curves */
    List<Ends> ends() {
        return panels.stream().flatMap(panel -> panel.charts().stream()).collect(Collectors.groupingBy(
                chart -> chart.y().label(), LinkedHashMap::new, Collectors.flatMapping(chart ->
                        chart.series().stream().filter(series -> !series.end().isEmpty()), Collectors.toList())))
                .entrySet().stream().filter(chart -> !chart.getValue().isEmpty())
                .map(chart -> new Ends(chart.getKey(), chart.getValue())).toList();
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
        if (format.slide() ? role == Role.WHOLE : panels.stream().flatMap(panel -> panel.charts().stream())
                .allMatch(chart -> solvers(chart).size() <= CURVES)) {
            return format.slide() ? List.of() : List.of(this);
        }
        if (panels.isEmpty()) {
            return List.of(this);
        }
        List<Picture> pictures = new ArrayList<>();
        for (Panel panel : panels) {
            for (int k = 0; k < panel.charts().size(); k++) {
                Chart chart = panel.charts().get(k);
                if (k > 0 && !chart.rows().isEmpty()) {
                    continue;                           // below the chart before; a slide has no room for them
                }
                String file = Stream.of(name, panel.name(), chart.name()).filter(part -> !part.isEmpty())
                        .collect(Collectors.joining("-"));
                String text = pictures.isEmpty() ? caption : panel.title() + ": " + chart.y().quantity() + ".";
                List<Chart> shown = panel.charts().subList(k, k + 1 < panel.charts().size()
                        && !panel.charts().get(k + 1).rows().isEmpty() ? k + 2 : k + 1);
                pictures.add(panels(file, text, panel.title(), format.slide()
                        ? List.of(panel.with(panel.title(), List.of(onSlide(chart)))) : groups(panel, shown)));
            }
        }
        return pictures;
    }

    private static List<SolverInfo> solvers(Chart chart) {
        return chart.series().stream().filter(series -> series.mark().isCurve())
                .flatMap(series -> series.look().solver().stream()).distinct().toList();
    }

    private Chart onSlide(Chart chart) {
        List<SolverInfo> shown = solvers(chart).stream().sorted(Comparator.comparingInt(solver ->
                first.contains(solver.name()) ? first.indexOf(solver.name()) : first.size()))
                .limit(Math.max(0, CURVES_ON_A_SLIDE - chart.series().stream().filter(series ->
                        series.mark().isCurve() && series.look().equals(Look.OWN)).count())).toList();
        Chart some = chart.only(series -> series.look().solver().isEmpty()
                || shown.contains(series.look().solver().get()));
        return chart.scale() == chart.series() ? some.scaledTo(some.series()) : some;
    }

    private static List<Panel> groups(Panel panel, List<Chart> charts) {
        List<Group> groups = solvers(charts.get(0)).stream().map(solver -> solver.family().group()).distinct().sorted()
                .toList();
        return groups.size() < 2 ? List.of(panel.with(panel.title(), charts)) : groups.stream().map(group ->
                panel.with(group.words, charts.stream().map(chart -> chart.only(series -> series.look().solver()
                        .map(solver -> solver.family().group() == group).orElse(true)))
                        .filter(chart -> !chart.series().isEmpty()).toList())).toList();
    }

    /** @return the page to be drawn; none if the picture is made elsewhere */
    public Optional<ChartPage> page(ChartFormat format) {
        return panels.isEmpty() ? drawn : Optional.of(panels.size() == 1
                ? ChartPage.of(panels.get(0), format) : PanelGrid.page(title, panels));
    }
}
