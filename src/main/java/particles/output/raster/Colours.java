package particles.output.raster;

import java.util.function.IntUnaryOperator;

/** Colours as 0xRRGGBB: mixing, and the scale of strain. */
public final class Colours {
    /** Compressed, at rest, stretched: a diverging scale that people with any colour vision can read. */
    static final int COMPRESSED = 0x2166ac;
    /** The colour of an unstrained spring. */
    public static final int AT_REST = 0xc9c6c0;
    /** The colour of a stretched spring. */
    static final int STRETCHED = 0xc4161c;

    private Colours() {
    }

    /** @return a at 0, b at 1, in between a mixture */
    public static int mix(int a, int b, double part) {
        double p = Math.max(0, Math.min(1, part));
        int mixed = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            int from = a >> shift & 255;
            mixed |= (int) Math.rint(from + p * ((b >> shift & 255) - from)) << shift;
        }
        return mixed;
    }

    /**
     * @param strain (length - rest length) / rest length
     * @param range  the strain that has the full colour
     */
    public static int ofStrain(double strain, double range) {
        double part = strain / range;
        return Double.isNaN(part) ? AT_REST : mix(AT_REST, part < 0 ? COMPRESSED : STRETCHED, Math.abs(part));
    }

    /** @return the mean of the colours of a pixel's four samples, 0 to 3, row by row */
    public static int mean(IntUnaryOperator sample) {
        int redBlue = 0;
        int green = 0;
        for (int k = 0; k < 4; k++) {
            int colour = sample.applyAsInt(k);
            redBlue += colour & 0xff00ff;
            green += colour & 0x00ff00;
        }
        return redBlue + 0x020002 >> 2 & 0xff00ff | green + 0x000200 >> 2 & 0x00ff00;
    }

    /** @return the colour in this light, with a white highlight on top */
    static int lit(int colour, float light, float highlight) {
        float white = 255 * highlight;
        int lit = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            lit |= (int) Math.min(255, (colour >> shift & 255) * light + white) << shift;
        }
        return lit;
    }
}
