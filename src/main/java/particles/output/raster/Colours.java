package particles.output.raster;

import java.util.function.IntUnaryOperator;

/** Colours as 0xRRGGBB: mixing, and the scale of strain. */
public final class Colours {
    /** Compressed, at rest, stretched: a diverging scale that people with any colour vision can read. */
    public static final int COMPRESSED = 0x2166ac;
    /** The colour of an unstrained spring. */
    public static final int AT_REST = 0xc9c6c0;
    /** The colour of a stretched spring. */
    public static final int STRETCHED = 0xc4161c;

    private Colours() {
    }

    /** @return a at 0, b at 1, in between a mixture */
    public static int mix(int a, int b, double part) {
        double p = Math.max(0, Math.min(1, part));
        int red = (int) Math.rint((a >> 16 & 255) + p * ((b >> 16 & 255) - (a >> 16 & 255)));
        int green = (int) Math.rint((a >> 8 & 255) + p * ((b >> 8 & 255) - (a >> 8 & 255)));
        int blue = (int) Math.rint((a & 255) + p * ((b & 255) - (a & 255)));
        return red << 16 | green << 8 | blue;
    }

    /**
     * @param strain (length - rest length) / rest length
     * @param range  the strain that has the full colour
     */
    public static int ofStrain(double strain, double range) {
        double part = strain / range;
        if (Double.isNaN(part)) {
            return AT_REST;
        }
        return mix(AT_REST, part < 0 ? COMPRESSED : STRETCHED, Math.min(1, Math.abs(part)));
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
    public static int lit(int colour, float light, float highlight) {
        float white = 255 * highlight;
        int red = (int) Math.min(255, (colour >> 16 & 255) * light + white);
        int green = (int) Math.min(255, (colour >> 8 & 255) * light + white);
        int blue = (int) Math.min(255, (colour & 255) * light + white);
        return red << 16 | green << 8 | blue;
    }
}
