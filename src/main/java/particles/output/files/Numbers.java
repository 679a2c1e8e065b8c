package particles.output.files;

import com.fasterxml.jackson.core.io.NumberOutput;

/**
 * Numbers in files: the shortest digits that read back as the same double, by one fixed algorithm (R. Giulietti, "The
 * Schubfach way to render doubles"), so that a file has the same bytes on every JDK; {@link Double#toString} changed
 * its digits in JDK 19.
 */
public final class Numbers {
    private Numbers() {
    }

    /** @return the digits, such as {@code 0.25}, {@code -0.0}, {@code 1.0E-5} */
    public static String shortest(double value) {
        return NumberOutput.toString(value, true);
    }

    /** @return the shortest digits that read back as the same float */
    public static String shortest(float value) {
        return NumberOutput.toString(value, true);
    }
}
