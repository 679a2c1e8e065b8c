package deSolvers.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

@Isolated("changes the locale of all tests")
class DigitsTest {
    @Test
    void numbersAreShortAndTheSameEverywhere() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            assertEquals("0.05", Digits.few(0.05));
            assertEquals("12.6", Digits.few(12.566370614359172));
            assertEquals("12.566370614359172", Digits.exact(12.566370614359172));
            assertEquals("0", Digits.few(-0.0));
            assertEquals("20", Digits.exact(20));
            assertEquals("6.02e23", Digits.few(6.02214e23));
            assertEquals("-1.5e-7", Digits.few(-1.5e-7));
            assertEquals("9.37e-6", Digits.few(0.000009366));
            assertEquals("1e-5", Digits.few(0.00001));
            assertEquals("1.2e-12", Digits.exact(0.0000000000012));
            assertEquals("not a number", Digits.few(Double.NaN));
            assertEquals("over 1e308", Digits.few(Double.POSITIVE_INFINITY));
            assertEquals("0.063", Digits.roundedDown(0.0639, 2));
            assertEquals("1000000", Digits.few(1e6));
            assertEquals("1.25e7", Digits.exact(new BigDecimal("12500000")));
            assertEquals("0.0001", Digits.exact(new BigDecimal("1e-4")));
        } finally {
            Locale.setDefault(before);
        }
    }
}
