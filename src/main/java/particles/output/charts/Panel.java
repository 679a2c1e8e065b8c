package particles.output.charts;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import particles.output.charts.SolverStyle.SolverFamily;
import particles.view.ChartData;
import particles.view.ChartData.Series;
import particles.view.ChartData.VectorField;

/**
 * A panel: one chart, or several above each other over the same x axis.
 *
 * @param charts the charts, the uppermost first; the title is that of the first
 * @param kind   the way of drawing it
 * @param field  the arrows behind a path in state space, if there are any
 */
public record Panel(List<ChartData> charts, Kind kind, Optional<VectorField> field) {
    /** The ways of drawing a chart. */
    public enum Kind {
        /** With axes that fill their room, and labels at the ends of its lines. */
        CHART,
        /** A path in state space. */
        PHASE,
        /** A map of a plane: a unit along x is as long as one along y, so that circles are round. */
        MAP,
    }

    /**
     * @param data its data
     * @return a chart
     */
    public static Panel chart(ChartData data) {
        return stacked(List.of(data));
    }

    /**
     * @param data a plane
     * @return a map, in which circles are round
     */
    public static Panel map(ChartData data) {
        return new Panel(List.of(data), Kind.MAP, Optional.empty());
    }

    /**
     * @param data  position against velocity: the path, then points to be marked, such as its start
     * @param field the arrows behind it, if there are any
     * @return a path in state space
     */
    public static Panel phase(ChartData data, Optional<VectorField> field) {
        return new Panel(List.of(data), Kind.PHASE, field);
    }

    /**
     * @param data the charts, the uppermost first
     * @return charts above each other
     */
    public static Panel stacked(List<ChartData> data) {
        return new Panel(data, Kind.CHART, Optional.empty());
    }

    /** @return the title above it */
    public String title() {
        return charts.get(0).title();
    }

    /** @return the number of different solvers in its fullest chart */
    public int curves() {
        return charts.stream().mapToInt(chart -> (int) chart.series().stream().map(Series::name)
                .filter(name -> SolverStyle.of(name).isPresent()).distinct().count()).max().orElse(0);
    }

    /**
     * @param rows whether rows stay below the chart that they follow; a slide has no room for them
     * @return each chart of a quantity as a panel of its own
     */
    public List<Panel> apart(boolean rows) {
        List<List<ChartData>> parts = new ArrayList<>();
        for (ChartData chart : charts) {
            if (parts.isEmpty() || chart.rows().isEmpty()) {
                parts.add(new ArrayList<>(List.of(chart)));
            } else if (rows) {
                parts.get(parts.size() - 1).add(chart);
            }
        }
        return parts.stream().map(this::of).toList();
    }

    /** @return a panel of this kind */
    private Panel of(List<ChartData> parts) {
        return new Panel(parts, kind, field);
    }

    /** @return the panel on the axes that all charts of its quantities in these panels would have */
    public Panel scaledTo(List<Panel> all) {
        return of(charts.stream().map(chart -> chart.scaledTo(all.stream().flatMap(panel -> panel.charts.stream())
                .filter(other -> other.yLabel().equals(chart.yLabel())).flatMap(other -> other.scale().stream())
                .toList())).toList());
    }

    /** @return the panel with another title */
    public Panel titled(String title) {
        List<ChartData> renamed = new ArrayList<>(charts);
        renamed.set(0, charts.get(0).titled(title));
        return of(renamed);
    }

    /** @return what is drawn, as a part of a file's name: its quantity without a unit, such as energy-error */
    public String quantity() {
        return fileName(charts.get(0).yLabel());
    }

    /** @return the begin of a text, up to a colon, comma or bracket, as a part of a file's name */
    public static String fileName(String text) {
        return text.replaceFirst("[:(/].*", "").toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9.]+", "-")
                .replaceAll("^-|-$", "");
    }

    /** @return the families of the solvers in its first chart */
    public Set<SolverFamily> families() {
        return charts.get(0).series().stream().flatMap(series -> SolverStyle.of(series.name()).stream())
                .map(SolverStyle::family).collect(Collectors.toCollection(() -> EnumSet.noneOf(SolverFamily.class)));
    }
}
