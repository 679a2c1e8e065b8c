package particles.output.animation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.differences;
import static particles.output.SmallPictures.state;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.FileImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.painters.FrameState;
import particles.view.RenderOptions;
import particles.view.Scenery;

/** The animation, read back by ImageIO and composed as a viewer does. */
class GifAnimationTest {
    private static final int W = 160;
    private static final int H = 120;

    @TempDir
    Path top;

    private static FrameRenderer renderer() {
        return new FrameRenderer(new FrameSetup(FRONT, RenderOptions.STANDARD, Scenery.NONE, "", ""), W, H, 2);
    }

    private static FrameState ball(int k) {
        return state(0.8 * k - 4, 0, 0);
    }

    private void write(double fps, int frames, int width) {
        FrameRenderer renderer = renderer();
        try (OutputFolder folder = OutputFolder.open(top);
                GifAnimation animation = new GifAnimation(folder, W, H, width, fps)) {
            for (int k = 0; k < frames; k++) {
                animation.prepare(k, renderer.render(ball(k))).run();
            }
        }
    }

    private record Frame(int[] rgb, int width, int delay, IIOMetadataNode metadata) {
    }

    private List<Frame> read() throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        List<Frame> frames = new ArrayList<>();
        try (FileImageInputStream in = new FileImageInputStream(new File(top.toFile(), "animation.gif"))) {
            reader.setInput(in);
            BufferedImage screen = null;
            for (int k = 0; k < reader.getNumImages(true); k++) {
                BufferedImage part = reader.read(k);
                IIOMetadataNode root = (IIOMetadataNode) reader.getImageMetadata(k)
                        .getAsTree("javax_imageio_gif_image_1.0");
                IIOMetadataNode place = (IIOMetadataNode) root.getElementsByTagName("ImageDescriptor").item(0);
                if (screen == null) {
                    screen = new BufferedImage(part.getWidth(), part.getHeight(), BufferedImage.TYPE_INT_RGB);
                }
                Graphics2D g = screen.createGraphics();
                g.drawImage(part, Integer.parseInt(place.getAttribute("imageLeftPosition")),
                        Integer.parseInt(place.getAttribute("imageTopPosition")), null);
                g.dispose();
                IIOMetadataNode control = (IIOMetadataNode) root.getElementsByTagName("GraphicControlExtension")
                        .item(0);
                frames.add(new Frame(screen.getRGB(0, 0, screen.getWidth(), screen.getHeight(), null, 0,
                        screen.getWidth()),
                        screen.getWidth(), Integer.parseInt(control.getAttribute("delayTime")), root));
            }
        }
        return frames;
    }

    /** At 30 frames a second delays are 3, 4, 3, 3, 4 ... hundredths: the sum, not each, is right. */
    @Test
    void delaysAddUpToTheTime() throws IOException {
        write(30, 31, W);
        List<Frame> frames = read();
        assertEquals(31, frames.size());
        assertEquals(100, frames.stream().limit(30).mapToInt(Frame::delay).sum());
        assertTrue(frames.stream().allMatch(f -> f.delay() == 3 || f.delay() == 4));
        IIOMetadataNode loop =
                (IIOMetadataNode) frames.get(0).metadata().getElementsByTagName("ApplicationExtension").item(0);
        assertEquals("NETSCAPE", loop.getAttribute("applicationID"));
        assertArrayEquals(new byte[] {1, 0, 0}, (byte[]) loop.getUserObject());
    }

    @Test
    void framesTooFastForViewersAreLeftOut() throws IOException {
        write(200, 41, W);
        List<Frame> frames = read();
        assertTrue(frames.stream().allMatch(f -> f.delay() >= 2));
        assertEquals(20, frames.stream().limit(frames.size() - 1).mapToInt(Frame::delay).sum(), 2);
    }

    /** Each frame, composed from its changes, is the picture that was drawn, up to the dither. */
    @Test
    void everyFrameReadsBackAsItsPicture() throws IOException {
        write(25, 11, W);
        List<Frame> frames = read();
        FrameRenderer renderer = renderer();
        for (int k = 0; k < 11; k++) {
            IntSummaryStatistics off = differences(renderer.render(ball(k)), frames.get(k).rgb());
            assertTrue(off.getAverage() < 3 && off.getMax() < 12, "frame " + k + " is off by " + off);   // 2.6 and 9
        }
    }

    @Test
    void theSkyBehindAMovingBallIsAsInTheFirstFrame() throws IOException {
        write(25, 11, W);
        List<Frame> frames = read();
        FrameRenderer renderer = renderer();
        int[] opening = renderer.render(ball(0)).clone();
        int[] end = renderer.render(ball(10));
        int[] first = frames.get(0).rgb();
        int[] last = frames.get(10).rgb();
        assertArrayEquals(new int[0], IntStream.range(0, W * H).filter(p -> end[p] == opening[p] && last[p] != first[p])
                .toArray());
    }

    /** What no palette holds at once is complete after some frames. */
    @Test
    void aPictureOfTooManyColoursHasSimilarOnesAndThenItsOwn() throws IOException {
        int[] rgb = IntStream.range(0, W * H).map(p -> p % W << 16 | p / W << 8 | 0x40).toArray();
        try (OutputFolder folder = OutputFolder.open(top);
                GifAnimation animation = new GifAnimation(folder, W, H, W, 25)) {
            for (int k = 0; k < 12; k++) {
                animation.prepare(k, rgb).run();
            }
        }
        IntSummaryStatistics off = differences(rgb, read().get(0).rgb());
        assertTrue(off.getAverage() < 3 && off.getMax() < 18, "off by " + off);     // measured 2.5 and 17 of 255
        off = differences(rgb, read().get(11).rgb());
        assertTrue(off.getAverage() < 3 && off.getMax() < 10, "off by " + off);     // 2.7 and 9, the dither
    }

    @Test
    void widePicturesAreShrunkByAWholeNumber() throws IOException {
        write(25, 2, 100);
        assertEquals(80, read().get(0).width());
    }
}
