package particles.law;

/** Checks numbers that a law, a rule or a run is given. */
public final class Require {
    private Require() {
    }

    /**
     * @param what the number's name, for the message
     * @return the number
     * @throws IllegalArgumentException if it is not positive and finite
     */
    public static double positive(String what, double value) {
        if (!(value > 0 && value <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException(what + " has to be positive and finite, not " + value);
        }
        return value;
    }

    /**
     * @param what the number's name, for the message
     * @return the number
     * @throws IllegalArgumentException if it is negative or not finite
     */
    public static double notNegative(String what, double value) {
        if (!(value >= 0 && value <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException(what + " has to be 0 or more and finite, not " + value);
        }
        return value;
    }
}
