package particles.output.animation;

import org.jcodec.common.model.Picture;

/**
 * Converts red, green and blue to the luma and chroma of films (ITU-R BT.709, 8 bits, luma from 16 to 235, chroma from
 * 16 to 240), the chroma as the mean of four pixels. It works in 16-bit fixed point; bytes of a picture are shifted by
 * 128, as the library needs them.
 */
final class FilmColours {
    private static final int BITS = 16;
    private static final double RED = 0.2126;
    private static final double BLUE = 0.0722;
    private static final double GREEN = 1 - RED - BLUE;
    private static final double LUMA_RANGE = 219.0 / 255;
    private static final double CHROMA_RANGE = 112.0 / 255;     // to either side of grey

    private static final int Y_RED = fixed(LUMA_RANGE * RED);
    private static final int Y_GREEN = fixed(LUMA_RANGE * GREEN);
    private static final int Y_BLUE = fixed(LUMA_RANGE * BLUE);
    private static final int CB_RED = fixed(-CHROMA_RANGE * RED / (1 - BLUE));
    private static final int CB_GREEN = fixed(-CHROMA_RANGE * GREEN / (1 - BLUE));
    private static final int CB_BLUE = -CB_RED - CB_GREEN;      // so that greys are grey
    private static final int CR_GREEN = fixed(-CHROMA_RANGE * GREEN / (1 - RED));
    private static final int CR_BLUE = fixed(-CHROMA_RANGE * BLUE / (1 - RED));
    private static final int CR_RED = -CR_GREEN - CR_BLUE;
    private static final int LUMA_OFFSET = (16 - 128 << BITS) + (1 << BITS - 1);
    private static final int ROUNDING = 1 << BITS + 1;

    private FilmColours() {
    }

    private static int fixed(double factor) {
        return (int) Math.round(factor * (1 << BITS));
    }

    /**
     * @param rgb       0xRRGGBB, row by row from the top
     * @param rowLength pixels from one row to the next
     * @param picture   receives the colours, of the same size, without an odd last column or row
     */
    static void convert(int[] rgb, int rowLength, Picture picture) {
        byte[] luma = picture.getPlaneData(0);
        byte[] blue = picture.getPlaneData(1);
        byte[] red = picture.getPlaneData(2);
        int width = picture.getWidth();
        for (int y = 0, chroma = 0; y < picture.getHeight(); y += 2) {
            for (int x = 0; x < width; x += 2, chroma++) {
                int r = 0;
                int g = 0;
                int b = 0;
                for (int k = 0; k < 4; k++) {
                    int row = y + (k >> 1);
                    int column = x + (k & 1);
                    int pixel = rgb[row * rowLength + column];
                    int pr = pixel >> 16 & 255;
                    int pg = pixel >> 8 & 255;
                    int pb = pixel & 255;
                    luma[row * width + column] = (byte) (Y_RED * pr + Y_GREEN * pg + Y_BLUE * pb + LUMA_OFFSET >> BITS);
                    r += pr;
                    g += pg;
                    b += pb;
                }
                blue[chroma] = (byte) (CB_RED * r + CB_GREEN * g + CB_BLUE * b + ROUNDING >> BITS + 2);
                red[chroma] = (byte) (CR_RED * r + CR_GREEN * g + CR_BLUE * b + ROUNDING >> BITS + 2);
            }
        }
    }
}
