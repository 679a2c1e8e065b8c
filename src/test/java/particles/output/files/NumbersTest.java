package particles.output.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Shortest digits of numbers: they read back as the same double, and no shorter ones do. */
class NumbersTest {

    @Test
    void knownNumbersHaveTheirShortestDigits() {
        assertEquals("0.1", Numbers.shortest(0.1));
        assertEquals("-0.0", Numbers.shortest(-0.0));
        assertEquals("1.0E-5", Numbers.shortest(1e-5));
        assertEquals("4.9E-324", Numbers.shortest(Double.MIN_VALUE));
        assertEquals("1.7976931348623157E308", Numbers.shortest(Double.MAX_VALUE));
        assertEquals("2.2E-322", Numbers.shortest(2.2E-322));           // JDK 17's Double.toString says 2.17E-322
        assertEquals("2.0E23", Numbers.shortest(2e23));                 // and here 1.9999999999999998E23
    }

    @Test
    void digitsReadBackToTheSameBitsAndAreShortest() {
        Random random = new Random(715);
        for (int i = 0; i < 20_000; i++) {
            double value = Double.longBitsToDouble(random.nextLong());
            if (!Double.isFinite(value)) {
                continue;
            }
            String digits = Numbers.shortest(value);
            assertEquals(Double.doubleToRawLongBits(value), Double.doubleToRawLongBits(Double.parseDouble(digits)),
                    digits);
            int count = new BigDecimal(digits).stripTrailingZeros().precision();
            if (count > 2) {        // two digits are always written
                BigDecimal shorter = new BigDecimal(value).round(new MathContext(count - 1));
                assertTrue(shorter.doubleValue() != value, digits + " could be " + shorter);
            }
        }
    }
}
