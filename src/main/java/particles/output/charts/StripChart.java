package particles.output.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.plot.ValueMarker;
import particles.view.Chart;
import particles.view.Panel;

/** A chart over time without a title or names of lines, on which a line moves. */
public final class StripChart {
    private final JFreeChart chart;
    private final ChartPlot plot;

    /** Creates a chart of these data. */
    public StripChart(Chart data) {
        chart = Charts.of(Panel.of("", List.of(data)), true, ChartFormat.PAGE);
        plot = Charts.plots(chart).get(0);
        plot.ends.labelled.clear();
        plot.setRoom(plot.beside.getLeft(), 0);
    }

    /**
     * Draws the chart.
     *
     * @param g    the graphics to draw on
     * @param area the rectangle to fill
     * @param time the time of the line (s)
     */
    public void draw(Graphics2D g, Rectangle2D area, double time) {
        plot.clearDomainMarkers();
        plot.addDomainMarker(new ValueMarker(time, ChartStyle.AXIS, ChartStyle.BAR));
        chart.draw(g, area);
    }
}
