package particles.teaching.exercises;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import particles.law.SeededRandom;
import particles.spec.Digest;

/**
 * A student's numbers in one exercise. They are the same on every machine and at every call, because they are derived
 * from the SHA-256 of the exercise's number and the student's id. Capitals and spaces around the id do not matter.
 *
 * @param student  an id with something in it
 * @param exercise the exercise's number
 */
public record Draw(String student, int exercise) {
    /** @throws IllegalArgumentException if the id is empty */
    public Draw {
        student = student.strip().toLowerCase(Locale.ROOT);
        if (student.isEmpty()) {
            throw new IllegalArgumentException("a student's id has to have something in it");
        }
    }

    /**
     * The sequence from which numbers are picked, one after the other.
     *
     * @param random the source of the numbers
     */
    public record Picks(SeededRandom random) {
        /** @return one of the numbers low, low + 1, ... high, each equally likely */
        public int whole(int low, int high) {
            return low + (int) (random.nextDouble() * (high - low + 1));
        }

        /**
         * @return a number with this many decimals between low and high, which are given in units of the last decimal
         */
        public double decimal(int low, int high, int decimals) {
            return new BigDecimal(whole(low, high)).movePointLeft(decimals).doubleValue();
        }

        /** @return a number of three digits between low and high; one of 1 to 2 is as likely as one of 10 to 20 */
        public double size(double low, double high) {
            double drawn = low * StrictMath.pow(high / low, random.nextDouble());
            return new BigDecimal(drawn).round(new MathContext(3)).doubleValue();
        }

        /** @return one of these numbers */
        public double of(double... choices) {
            return choices[whole(0, choices.length - 1)];
        }
    }

    /** @return the sequence, from its beginning */
    public Picks picks() {
        String digest = Digest.of("exercise " + exercise + " of " + student);
        return new Picks(new SeededRandom(Long.parseUnsignedLong(digest, 0, 16, 16)));
    }

    /** @return a drawn number as people write it */
    public static String text(double x) {
        return new BigDecimal(Double.toString(x)).stripTrailingZeros().toPlainString();
    }
}
