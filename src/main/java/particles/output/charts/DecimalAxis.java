package particles.output.charts;

import deSolvers.text.Digits;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.math.BigDecimal;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.TickUnit;
import org.jfree.chart.axis.TickUnitSource;
import org.jfree.data.Range;

/**
 * An axis with ticks at multiples of 1, 2 or 5 times any power of ten, labelled with exactly the digits that they need:
 * {@code 0.25}, {@code 1000}, {@code 2e-14}. JFreeChart's own ticks are rounded to ten decimals, so that small drifts
 * would all read 0, and it measures labels at both ends of the range only: from 0 to 8 in steps of 0.2 the ones between
 * are wider.
 */
final class DecimalAxis extends NumberAxis {
    private static final long serialVersionUID = 1L;
    /** More ticks than this never fit. */
    private static final int MOST_TICKS = 100;
    /** The room of a label, in widths of a digit more than it needs itself. */
    private static final int AIR = 2;

    DecimalAxis() {
        setStandardTickUnits(new Ticks());
    }

    @Override
    protected double estimateMaximumTickLabelWidth(Graphics2D g2, TickUnit unit) {
        FontMetrics metrics = g2.getFontMetrics(getTickLabelFont());
        Range range = getRange();
        double widest = super.estimateMaximumTickLabelWidth(g2, unit);
        double first = Math.ceil(range.getLowerBound() / unit.getSize());
        for (int k = 0; k < MOST_TICKS && (first + k) * unit.getSize() <= range.getUpperBound(); k++) {
            widest = Math.max(widest, metrics.stringWidth(unit.valueToString((first + k) * unit.getSize())));
        }
        return widest + AIR * metrics.charWidth('0');
    }

    /** Finds the distance of ticks. */
    static final class Ticks implements TickUnitSource {
        @Override
        public TickUnit getLargerTickUnit(TickUnit unit) {
            return getCeilingTickUnit(unit.getSize() * 1.5);
        }

        @Override
        public TickUnit getCeilingTickUnit(TickUnit unit) {
            return getCeilingTickUnit(unit.getSize());
        }

        @Override
        public TickUnit getCeilingTickUnit(double size) {
            return new Unit(Digits.roundStep(size));
        }
    }

    /** A distance of ticks. */
    private static final class Unit extends NumberTickUnit {
        private static final long serialVersionUID = 1L;

        private final BigDecimal size;

        Unit(BigDecimal size) {
            super(size.doubleValue());
            this.size = size;
        }

        /** The tick's value has round-off; it is a whole number of units. */
        @Override
        public String valueToString(double value) {
            double units = Math.rint(value / getSize());
            return Math.abs(units) < 1e15 ? Digits.exact(size.multiply(BigDecimal.valueOf((long) units)))
                    : Double.toString(value);
        }
    }
}
