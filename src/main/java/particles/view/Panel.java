package particles.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A panel: one chart, or several above each other over the same x axis.
 *
 * @param name   the name that its picture has where it is drawn by itself; empty if it is the only one
 * @param title  what is drawn
 * @param answer the number that is the point of the panel, in one line; may be empty
 * @param charts the charts, the uppermost first
 * @param kind   the way of drawing it
 * @param field  the arrows behind a path in state space, if there are any
 */
public record Panel(String name, String title, String answer, List<Chart> charts, Kind kind,
                    Optional<VectorField> field) {
    /** The ways of drawing a chart. */
    public enum Kind {
        /** With axes that fill their room, and names at the ends of its lines. */
        CHART,
        /** A path in state space; circles are round if both axes have about the same range. */
        PHASE,
        /** A map of a plane: a unit along x is as long as one along y, so that circles are round. */
        MAP,
    }

    /** @return a chart, or charts above each other */
    public static Panel of(String title, List<Chart> charts) {
        return new Panel("", title, "", charts, Kind.CHART, Optional.empty());
    }

    /** @return a map of a plane */
    public static Panel map(String title, Chart chart) {
        return new Panel("", title, "", List.of(chart), Kind.MAP, Optional.empty());
    }

    /** @return a path in state space, with arrows behind it if there are any */
    public static Panel phase(String title, Chart chart, Optional<VectorField> field) {
        return new Panel("", title, "", List.of(chart), Kind.PHASE, field);
    }

    /** @return the panel with a name for its picture */
    public Panel named(String name) {
        return new Panel(name, title, answer, charts, kind, field);
    }

    /** @return the panel with a line below its title */
    public Panel answered(String answer) {
        return new Panel(name, title, answer, charts, kind, field);
    }

    /** @return each chart of a quantity, with the rows below it */
    public List<List<Chart>> parts() {
        List<List<Chart>> parts = new ArrayList<>();
        for (Chart chart : charts) {
            if (parts.isEmpty() || chart.rows().isEmpty()) {
                parts.add(new ArrayList<>());
            }
            parts.get(parts.size() - 1).add(chart);
        }
        return parts;
    }

    /** @return the panel with other charts */
    public Panel with(String title, List<Chart> charts) {
        return new Panel(name, title, answer, charts, kind, field);
    }
}
