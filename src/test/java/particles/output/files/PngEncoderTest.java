package particles.output.files;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Random;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** The encoder's pictures, decoded by ImageIO. */
class PngEncoderTest {

    private static void assertReadsBack(int width, int height, IntBinaryOperator colour) throws IOException {
        int[] rgb = new int[width * height];
        for (int p = 0; p < rgb.length; p++) {
            rgb[p] = colour.applyAsInt(p % width, p / width);
        }
        BufferedImage read = ImageIO.read(new ByteArrayInputStream(PngEncoder.file(width, height, rgb)));
        assertEquals(width, read.getWidth());
        assertEquals(height, read.getHeight());
        for (int p = 0; p < rgb.length; p++) {
            assertEquals(rgb[p] & 0xffffff, read.getRGB(p % width, p / width) & 0xffffff, "pixel " + p);
        }
    }

    /** The top byte, which text drawn by Java sets, is left out. */
    @Test
    void everyPixelReadsBack() throws IOException {
        Random random = new Random(715);
        assertReadsBack(317, 211, (x, y) -> random.nextInt());
        assertReadsBack(317, 211, (x, y) -> x << 16 | y << 8 | 255 - y);
        assertReadsBack(317, 211, (x, y) -> y * 0x010203);
        assertReadsBack(317, 211, (x, y) -> x / 7 * 0x030201);
        assertReadsBack(1, 1, (x, y) -> 0x123456);
    }
}
