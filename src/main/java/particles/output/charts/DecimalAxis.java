package particles.output.charts;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.TickUnit;
import org.jfree.data.Range;
import particles.output.text.DecimalTicks;

/**
 * An axis with {@link DecimalTicks} whose labels do not run into each other: JFreeChart measures those at both ends of
 * the range, and from 0 to 8 in steps of 0.2 the ones between are wider.
 */
final class DecimalAxis extends NumberAxis {
    private static final long serialVersionUID = 1L;
    /** More ticks than this never fit. */
    private static final int MOST_TICKS = 100;
    /** The room of a label, in widths of a digit more than it needs itself. */
    private static final int AIR = 2;

    DecimalAxis() {
        setStandardTickUnits(new DecimalTicks());
    }

    @Override
    protected double estimateMaximumTickLabelWidth(Graphics2D g2, TickUnit unit) {
        if (isVerticalTickLabels()) {
            return super.estimateMaximumTickLabelWidth(g2, unit);
        }
        FontMetrics metrics = g2.getFontMetrics(getTickLabelFont());
        Range range = getRange();
        double widest = super.estimateMaximumTickLabelWidth(g2, unit);
        double first = Math.ceil(range.getLowerBound() / unit.getSize());
        for (int k = 0; k < MOST_TICKS && (first + k) * unit.getSize() <= range.getUpperBound(); k++) {
            widest = Math.max(widest, metrics.stringWidth(unit.valueToString((first + k) * unit.getSize())));
        }
        return widest + AIR * metrics.charWidth('0');
    }
}
