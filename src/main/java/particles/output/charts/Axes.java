package particles.output.charts;

import deSolvers.text.Digits;
import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import org.jfree.chart.axis.AxisSpace;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.NumberTickUnitSource;
import org.jfree.chart.axis.SymbolAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.data.Range;
import particles.output.files.FontCheck;
import particles.view.Axis;

/** Makes axes whose ticks, and so the room that they need, are known before they are drawn. */
final class Axes {
    private static final NumberTickUnitSource UNITS = new NumberTickUnitSource();
    private static final FontRenderContext FONTS = new FontRenderContext(null, true, true);
    /** Values that differ by less than this part of their size differ by round-off: they are one value on an axis. */
    private static final double ROUNDING = 1e-13;
    /** An axis that begins this near to zero, as a part of its end, begins at zero. */
    private static final double NEAR_ZERO = 0.1;
    /** The part of its range that an axis shows beyond the first and the last point, where marks need it. */
    private static final double MARGIN = 0.05;
    /** The height of a line of text with its margin. */
    private static final double LINE = 20;
    /** The width of a number such as -1.5e-15 with its margins. */
    private static final double NUMBER = 64;
    /** From this power of ten on, zeros would have to be counted. */
    private static final int LARGE = 5;
    /** Removes the round-off of a tick's value. */
    private static final MathContext DIGITS = new MathContext(6);

    private Axes() {
    }

    /**
     * @param values the range of the values; null, as in JFreeChart, if there are none, and so no numbers beside it
     * @param tight  whether it ends at the first and last point
     * @param most   the largest number of ticks
     */
    static ValueAxis of(Axis axis, Range values, boolean tight, int most) {
        double margin = tight ? 0 : MARGIN;
        ValueAxis made;
        if (axis.log()) {
            made = new DecadeAxis(values == null ? new Range(1, 1000) : decades(values, margin), most);
        } else {
            NumberAxis linear = new NumberAxis();
            linear.setRange(values == null ? new Range(0, 1) : numbers(values, margin));
            setTicks(linear, linear.getRange().getLength() / most);
            made = linear;
        }
        made.setLabel(axis.label());
        made.setTickLabelsVisible(values != null);
        return made;
    }

    static void setTicks(NumberAxis axis, double least) {
        axis.setTickUnit(new NumberTickUnit(unit(least)) {
            private static final long serialVersionUID = 1L;

            @Override
            public String valueToString(double value) {
                return text(value);
            }
        });
    }

    /** @return the smallest distance of ticks that is round and at least as long */
    static double unit(double least) {
        return UNITS.getCeilingTickUnit(least).getSize();
    }

    /** @return a number on an axis: 100, 0.25, 1e6, 2e-14 */
    static String text(double value) {
        BigDecimal number = BigDecimal.valueOf(value).round(DIGITS);
        int exponent = number.precision() - number.scale() - 1;
        return exponent < LARGE ? Digits.exact(number) : Digits.exact(number.scaleByPowerOfTen(-exponent)) + "e"
                + exponent;
    }

    private static Range decades(Range values, double margin) {
        double low = Math.log10(values.getLowerBound());
        double high = Math.log10(values.getUpperBound());
        double beside = margin * (high - low) + (high - low < ROUNDING ? 0.5 : 0);
        return new Range(Math.pow(10, low - beside), Math.pow(10, high + beside));
    }

    /** Around one value an axis is as long as the value is large; without margins, an axis shows zero if it is near. */
    private static Range numbers(Range values, double margin) {
        double low = values.getLowerBound();
        double high = values.getUpperBound();
        double size = Math.max(Math.abs(low), Math.abs(high));
        double beside = high - low > Math.max(ROUNDING * size, Double.MIN_NORMAL) ? margin * (high - low)
                : size == 0 ? 0.5 : Math.max(size, Double.MIN_NORMAL) / 2;
        return new Range(margin == 0 && low > 0 && low < NEAR_ZERO * high ? 0 : low - beside, high + beside);
    }

    /** @return an axis with a name for each row, the first one above */
    static ValueAxis rows(String label, List<String> rows) {
        SymbolAxis axis = new SymbolAxis(label, rows.toArray(new String[0]));
        axis.setGridBandsVisible(false);
        axis.setInverted(true);
        axis.setRange(-0.8, rows.size() - 0.2);
        return axis;
    }

    /** @return the room for a text, in pixels of the layout; 0 on a machine without fonts, which draws no chart */
    static double width(Font font, String text) {
        return FontCheck.isAvailable() ? font.getStringBounds(text, FONTS).getWidth() : 0;
    }

    /** @return the room of an axis below a chart */
    static AxisSpace below() {
        AxisSpace space = new AxisSpace();
        space.setBottom(2 * LINE);
        return space;
    }

    /** @return the room of an axis at the left of a chart: for numbers, or for the names of rows */
    static double left(ValueAxis axis) {
        return LINE + (axis instanceof SymbolAxis rows ? 10 + Arrays.stream(rows.getSymbols())
                .mapToDouble(name -> width(ChartStyle.TICKS, name)).max().orElse(0) : NUMBER);
    }
}
