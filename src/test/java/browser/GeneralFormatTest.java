package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.lab.browser.Missing;

/** The page's own %g writes what Java's writes. */
class GeneralFormatTest {

    @ParameterizedTest
    @ValueSource(doubles = {0, 1, -1, 0.1, 9.9999, 99995, 123456789, 1e-4, 9.9996e-5, 1.5e-300, -2.5e21, 1234.5, 1e15})
    void numbersAreWrittenAsByJava(double value) {
        for (String format : new String[] {"%.4g J", "%g", "at %s: %.2g of %d %%"}) {
            Object[] arguments = format.startsWith("at") ? new Object[] {"x", value, 3} : new Object[] {value};
            assertEquals(String.format(Locale.ROOT, format, arguments), Missing.format(Locale.ROOT, format, arguments));
        }
    }
}
