package particles.output.charts;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.Range;

/**
 * A logarithmic axis with ticks at every power of ten, or every second, third and so on; an axis with less than three
 * powers of ten has more digits, where JFreeChart has powers alone.
 */
final class DecadeAxis extends LogAxis {
    private static final long serialVersionUID = 1L;
    private static final int FEWEST = 3;
    /** Digits between powers of ten, as few as are enough; where none are, ticks are those of a linear axis. */
    private static final List<double[]> DIGITS = List.of(new double[] {1}, new double[] {1, 3}, new double[] {1, 2, 5});

    private final double[] ticks;

    /** @param most the largest number of ticks at powers of ten */
    DecadeAxis(Range range, int most) {
        setSmallestValue(Double.MIN_NORMAL);
        setRange(range);
        ticks = ticks(range, most);
    }

    static double[] ticks(Range range, int most) {
        double decades = Math.log10(range.getUpperBound() / range.getLowerBound());
        double[] powers = at(range, Math.max(1, (int) Math.ceil(decades / most)), DIGITS.get(0));
        return powers.length >= FEWEST ? powers : DIGITS.stream().map(digits -> at(range, 1, digits))
                .filter(ticks -> ticks.length >= FEWEST).findFirst()
                .orElseGet(() -> multiples(range, Axes.unit(range.getLength() / most)));
    }

    private static double[] multiples(Range range, double unit) {
        return DoubleStream.iterate(Math.ceil(range.getLowerBound() / unit), k -> k * unit <= range.getUpperBound(),
                k -> k + 1).map(k -> k * unit).toArray();
    }

    private static double[] at(Range range, int step, double[] digits) {
        int first = (int) Math.floor(Math.log10(range.getLowerBound()) / step) * step;
        int last = (int) Math.ceil(Math.log10(range.getUpperBound()));
        return IntStream.iterate(first, power -> power <= last, power -> power + step).boxed()
                .flatMapToDouble(power -> DoubleStream.of(digits).map(digit -> digit * Math.pow(10, power)))
                .filter(range::contains).toArray();
    }

    @Override
    public List<?> refreshTicks(Graphics2D g, AxisState state, Rectangle2D area, RectangleEdge edge) {
        TextAnchor anchor = RectangleEdge.isTopOrBottom(edge) ? TextAnchor.TOP_CENTER : TextAnchor.CENTER_RIGHT;
        return DoubleStream.of(ticks).mapToObj(value -> new NumberTick(value, Axes.text(value), anchor,
                TextAnchor.CENTER, 0)).toList();
    }
}
