package particles.output.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Shortest digits of numbers: they read back as the same double, and no shorter ones do. */
class NumbersTest {

    /** JDK 17's Double.toString says 2.17E-322 and 1.9999999999999998E23 of the last two. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            0.1, 0.1
            -0.0, -0.0
            1e-5, 1.0E-5
            4.9e-324, 4.9E-324
            1.7976931348623157e308, 1.7976931348623157E308
            2.2e-322, 2.2E-322
            2e23, 2.0E23
            """)
    void knownNumbersHaveTheirShortestDigits(double number, String digits) {
        assertEquals(digits, Numbers.shortest(number));
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
