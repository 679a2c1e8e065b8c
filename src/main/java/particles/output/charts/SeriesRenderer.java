package particles.output.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;

/** The renderer of a chart's series: each is drawn by its mark in its look, and no two lines are alike. */
final class SeriesRenderer extends XYLineAndShapeRenderer {
    private static final long serialVersionUID = 1L;

    private SeriesRenderer() {
    }

    /** Draws a whole line, or fills what it encloses. */
    @Override
    protected void drawFirstPassShape(Graphics2D g, int pass, int k, int item, Shape line) {
        if (((ChartDataset) getPlot().getDataset()).series(k).mark() == Mark.FILL) {
            Path2D area = new Path2D.Double(Path2D.WIND_EVEN_ODD);
            area.append(line, false);
            g.setPaint(getItemPaint(k, item));
            g.fill(area);
        } else {
            super.drawFirstPassShape(g, pass, k, item, line);
        }
    }

    /**
     * @param path   whether they are paths in state space; dense ones let shine through what is below
     * @param format the format of the picture
     */
    static XYLineAndShapeRenderer of(List<Series> series, boolean path, ChartFormat format) {
        SeriesRenderer renderer = new SeriesRenderer();
        renderer.setDrawSeriesLineAsPath(true);         // dashes run on from point to point
        renderer.setAutoPopulateSeriesPaint(false);     // or a theme removes what is set here
        renderer.setAutoPopulateSeriesStroke(false);
        renderer.setUseOutlinePaint(true);
        renderer.setDataBoundsIncludesVisibleSeriesOnly(false);     // or y is not that of a point at the end of x
        renderer.setUseFillPaint(true);
        renderer.setLegendItemLabelGenerator((dataset, k) -> ((ChartDataset) dataset).series(k).name());
        renderer.setLegendLine(ChartStyle.LEGEND_LINE);
        List<Look> looks = looks(series);
        for (int k = 0; k < series.size(); k++) {
            Series one = series.get(k);
            Mark mark = one.mark();
            boolean dense = path && mark == Mark.LINE && (Series.isDense(one.x()) || Series.isDense(one.y()));
            boolean open = mark == Mark.OPEN_POINTS;
            boolean failed = mark == Mark.FAILURES;
            Color colour = format.on(new Color((failed ? Look.FAILURE : looks.get(k)).rgb()));
            Color ground = format.on(Color.WHITE);
            int variant = looks.get(k).variant();
            renderer.setSeriesLinesVisible(k, mark.isCurve() || mark == Mark.FILL);
            renderer.setSeriesShapesVisible(k, mark != Mark.LINE && !mark.isWide());
            renderer.setSeriesPaint(k, dense || mark.isWide() ? ChartStyle.pale(colour) : colour);
            renderer.setSeriesStroke(k, dense ? ChartStyle.THIN : mark.isWide() ? ChartStyle.BAND
                    : ChartStyle.stroke(variant));
            renderer.setSeriesShape(k, failed ? ChartStyle.FAILURE : ChartStyle.shape(variant));
            renderer.setSeriesFillPaint(k, open ? ground : colour);
            renderer.setSeriesOutlinePaint(k, open ? colour : ground);
            renderer.setSeriesOutlineStroke(k, open ? ChartStyle.BAR : ChartStyle.THIN);
        }
        return renderer;
    }

    /** If a line of another name has a series' look already, the series gets dashes that are free. */
    private static List<Look> looks(List<Series> series) {
        Map<List<Integer>, String> lines = new HashMap<>();
        List<Look> looks = new ArrayList<>();
        for (Series one : series) {
            Look look = one.look();
            for (int n = 0; one.mark().isCurve() && n < ChartStyle.STROKES
                    && !one.name().equals(lines.computeIfAbsent(key(look), free -> one.name())); n++) {
                look = look.variant(n);
            }
            looks.add(look);
        }
        return looks;
    }

    /** Not the record itself: Java would generate its equality at run time, several per cent of a short run. */
    private static List<Integer> key(Look look) {
        return List.of(look.rgb(), look.variant());
    }
}
