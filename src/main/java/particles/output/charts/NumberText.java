package particles.output.charts;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.text.FieldPosition;
import java.text.NumberFormat;
import java.text.ParsePosition;

/** The format of numbers on all axes: 100, 0.25, 1e6, 2e-14. */
final class NumberText extends NumberFormat {
    private static final long serialVersionUID = 1L;
    /** From this power of ten on, zeros would have to be counted. */
    private static final int LARGE = 5;
    /** Removes the round-off of a tick's value. */
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
