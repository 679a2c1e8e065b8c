package particles.output.text;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.RoundingMode;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.TickUnit;
import org.jfree.chart.axis.TickUnitSource;

/**
 * Axis ticks at multiples of 1, 2 or 5 times any power of ten, labelled with exactly the digits that they need: {@code
 * 0.25}, {@code 1000}, {@code 2e-14}. JFreeChart's own ticks are rounded to ten decimals, so that small drifts would
 * all read 0.
 */
public final class DecimalTicks implements TickUnitSource {
    /** One of the units: 1, 2 or 5 times a power of ten. */
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

    @Override
    public TickUnit getLargerTickUnit(TickUnit unit) {
        return getCeilingTickUnit(unit.getSize() * 1.5);
    }

    @Override
    public TickUnit getCeilingTickUnit(TickUnit unit) {
        return getCeilingTickUnit(unit.getSize());
    }

    /** The smallest unit that is at least this large, up to round-off. */
    @Override
    public TickUnit getCeilingTickUnit(double size) {
        double wanted = Math.max(size, Double.MIN_NORMAL) * (1 - 1e-9);
        BigDecimal power = BigDecimal.ONE.scaleByPowerOfTen(
                BigDecimal.valueOf(Math.log10(wanted)).setScale(0, RoundingMode.FLOOR).intValue());
        for (int factor : new int[] {1, 2, 5}) {
            BigDecimal unit = power.multiply(BigDecimal.valueOf(factor));
            if (unit.doubleValue() >= wanted) {
                return new Unit(unit);
            }
        }
        return new Unit(power.scaleByPowerOfTen(1));
    }
}
