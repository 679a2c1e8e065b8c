package particles.output.report;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.block.RectangleConstraint;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.Size2D;
import org.jfree.data.Range;
import particles.output.charts.ChartLegend;
import particles.output.charts.ChartStyle;
import particles.output.charts.ChartWriter;
import particles.output.charts.Charts;
import particles.output.charts.PhasePlot;
import particles.output.files.OutputFolder;
import particles.output.text.FontCheck;

/** Small multiples: charts in a grid, under one title and over one legend. */
final class PanelWriter {
    private static final int WIDTH = 1100;
    private static final double HEIGHT_OF_WIDTH = 0.8;
    private static final int HEAD = 44;
    private static final int MARGIN = 10;

    private PanelWriter() {
    }

    static void write(OutputFolder folder, String name, String title, int columns, List<ResultPage.Panel> panels) {
        FontCheck.require(folder.getPath().resolve(name));
        List<JFreeChart> charts = panels.stream().map(panel -> panel.phase() ? PhasePlot.of(panel.data(), panel.field())
                : Charts.of(panel.data())).toList();
        LegendTitle legend = ChartLegend.of(charts.stream().map(JFreeChart::getXYPlot)
                .sorted(Comparator.comparing((XYPlot plot) -> -plot.getDataset().getSeriesCount())).toList(), true);
        for (JFreeChart chart : charts) {
            chart.removeLegend();
            chart.getTitle().setFont(ChartStyle.LABEL);
            chart.setPadding(new RectangleInsets(4, 4, 4, 8));
        }
        double cellWidth = (WIDTH - 2.0 * MARGIN) / columns;
        double cellHeight = HEIGHT_OF_WIDTH * cellWidth;
        int rows = (charts.size() + columns - 1) / columns;
        double bottom = HEAD + rows * cellHeight;
        Size2D size = measure(legend);
        ChartWriter.write(folder, name, WIDTH, (int) Math.ceil(bottom + size.height + MARGIN), g -> {
            g.setColor(Color.WHITE);
            g.fill(new Rectangle2D.Double(0, 0, WIDTH, bottom + size.height + MARGIN));
            g.setColor(ChartStyle.TEXT);
            g.setFont(ChartStyle.TITLE);
            g.drawString(title, (float) (WIDTH - g.getFontMetrics().getStringBounds(title, g).getWidth()) / 2, 28);
            for (int k = 0; k < charts.size(); k++) {
                charts.get(k).draw(g, new Rectangle2D.Double(MARGIN + k % columns * cellWidth,
                        HEAD + k / columns * cellHeight,
                        cellWidth, cellHeight));
            }
            legend.draw(g, new Rectangle2D.Double((WIDTH - size.width) / 2, bottom, size.width, size.height));
        });
    }

    private static Size2D measure(LegendTitle legend) {
        Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        Size2D size = legend.arrange(g, new RectangleConstraint(new Range(0, WIDTH - 2.0 * MARGIN), new Range(0, 400)));
        g.dispose();
        return size;
    }
}
