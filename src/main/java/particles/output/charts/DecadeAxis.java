package particles.output.charts;

import deSolvers.text.Digits;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;
import java.math.MathContext;
import java.text.FieldPosition;
import java.text.NumberFormat;
import java.text.ParsePosition;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.axis.NumberTickUnitSource;
import org.jfree.chart.axis.ValueTick;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;

/**
 * A logarithmic axis with ticks at powers of ten. Where JFreeChart finds less than three, they are closer; an axis with
 * less than three powers of ten has ticks at 1, 2 and 5 times those, or, where labels are too wide, at 1 and 3 times.
 */
final class DecadeAxis extends LogAxis {
    private static final long serialVersionUID = 1L;
    private static final int FEWEST = 3;
    private static final int[] DIGITS = {1, 2, 5};
    private static final int[] FEWER_DIGITS = {1, 3};

    DecadeAxis() {
        setNumberFormatOverride(new PowerFormat());
        setStandardTickUnits(new NumberTickUnitSource(true));
        setSmallestValue(Double.MIN_NORMAL);
    }

    @Override
    public List<?> refreshTicks(Graphics2D g2, AxisState state, Rectangle2D area, RectangleEdge edge) {
        List<?> powers = super.refreshTicks(g2, state, area, edge);
        long labels = powers.stream().map(tick -> ((ValueTick) tick).getText())
                .filter(text -> text != null && !text.isEmpty()).count();       // marks between have none
        if (labels >= FEWEST) {
            return powers;
        }
        List<NumberTick> ticks = new ArrayList<>();
        TextAnchor anchor = RectangleEdge.isTopOrBottom(edge) ? TextAnchor.TOP_CENTER : TextAnchor.CENTER_RIGHT;
        double low = Math.log10(getLowerBound());
        double decades = Math.log10(getUpperBound()) - low;
        int step = Math.max(1, (int) (decades / FEWEST));
        int first = step * (int) Math.floor(low / step);
        double room = RectangleEdge.isTopOrBottom(edge) ? area.getWidth() * Math.log10(2) / decades
                : Double.POSITIVE_INFINITY;
        FontMetrics metrics = g2.getFontMetrics(getTickLabelFont());
        boolean narrow = IntStream.rangeClosed(first, (int) Math.ceil(low + decades)).anyMatch(power ->
                metrics.stringWidth(label(2 * Math.pow(10, power))) > room);
        int[] between = narrow ? FEWER_DIGITS : DIGITS;
        for (int power = first; power <= low + decades; power += step) {
            for (int digit : decades < FEWEST ? between : new int[] {1}) {
                double value = digit * Math.pow(10, power);
                if (getRange().contains(value)) {
                    ticks.add(new NumberTick(value, label(value), anchor, TextAnchor.CENTER, 0));
                }
            }
        }
        return ticks;
    }

    private String label(double value) {
        return getNumberFormatOverride().format(value);
    }

    /** Number format of powers of ten on a logarithmic axis: 100, 0.01, 1e6. */
    static final class PowerFormat extends NumberFormat {
        private static final long serialVersionUID = 1L;
        /** From this power on, zeros would have to be counted. */
        private static final int LARGE = 5;
        /** Removes the round-off of a power of ten. */
        private static final MathContext DIGITS = new MathContext(6);

        @Override
        public StringBuffer format(double number, StringBuffer text, FieldPosition position) {
            if (!Double.isFinite(number)) {
                return text;
            }
            BigDecimal rounded = new BigDecimal(number).round(DIGITS).stripTrailingZeros();
            int exponent = rounded.precision() - rounded.scale() - 1;
            return text.append(exponent >= LARGE ? Digits.exact(rounded.scaleByPowerOfTen(-exponent)) + "e" + exponent
                    : Digits.exact(rounded));
        }

        @Override
        public StringBuffer format(long number, StringBuffer text, FieldPosition position) {
            return format((double) number, text, position);
        }

        @Override
        public Number parse(String text, ParsePosition position) {
            throw new UnsupportedOperationException("an axis writes numbers and reads none");
        }
    }
}
