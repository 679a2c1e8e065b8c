package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Method;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.lab.browser.Missing;

/** What the page calls in place of our own methods has the same results. */
class MissingTest {

    @ParameterizedTest
    @ValueSource(doubles = {0, 1, -1, 3, 1e-310, Double.MIN_VALUE, Double.MIN_NORMAL, -1e300, 0.1, 4503599627370496.5,
            Double.MAX_VALUE, Double.NEGATIVE_INFINITY, Double.NaN})
    void theUnitInTheLastPlaceIsJavas(double value) {
        assertEquals(Math.ulp(value), Missing.ulp(value));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, -1, 1, Double.MIN_VALUE, 9.999999999999998e-281, 1e-280, 1e-279, 9.9e279,
            9.999999999999998e279, 1e280, 1.1e280, Double.MAX_VALUE, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
            Double.NaN})
    void lengthsOfSpringsAreOrdinaryWhereJavaSaysSo(double square) throws ReflectiveOperationException {
        Method isOrdinary = Class.forName("particles.effects.springs.SpringKernel")
                .getDeclaredMethod("isOrdinary", double.class);
        isOrdinary.setAccessible(true);
        assertEquals(isOrdinary.invoke(null, square), Missing.isOrdinary(square));
    }
}
