package particles.output.charts;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.text.FieldPosition;
import java.text.NumberFormat;
import java.text.ParsePosition;

/** Number format of powers of ten on a logarithmic axis: 100, 0.01, 1e-6. */
final class PowerFormat extends NumberFormat {
    private static final long serialVersionUID = 1L;
    /** Removes the round-off of a power of ten. */
    private static final MathContext DIGITS = new MathContext(6);

    @Override
    public StringBuffer format(double number, StringBuffer text, FieldPosition position) {
        return text.append(Double.isFinite(number) ? Digits.exact(new BigDecimal(number).round(DIGITS)) : "");
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
