package particles.output.frames;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.plain;
import static particles.output.SmallPictures.state;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.painters.FrameState;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.Scenery;
import particles.view.SpringView.SpringList;

/** The words of a picture can be read, whatever is behind them. */
class FrameTextTest {
    private static final int W = 960;
    private static final int H = 540;
    private static final Color SPRING = new Color(0xc4161c);

    private static BufferedImage onRed(FrameText text, FrameState state) {
        BufferedImage picture = new BufferedImage(W, H, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        g.setColor(SPRING);
        g.fillRect(0, 0, W, H);
        text.draw(g, state, true);
        g.dispose();
        return picture;
    }

    /** Just left of the first letter nothing is drawn but the ground. */
    @Test
    void wordsOfABlowUpHaveAGroundOfTheirOwn() {
        RenderOptions look = plain(0x0000ff, 1, ParticleStyle.STANDARD);
        FrameText text = new FrameText(new FrameSetup(FRONT, look, Scenery.NONE, "A title", "rk4"), W, H, 2);
        FrameState state = state();
        List<Rectangle2D> usual = text.boxes(state, true);
        BufferedImage without = onRed(text, state);
        usual.forEach(box -> assertEquals(SPRING.getRGB(), ground(without, box)));
        FrameState blownUp = new FrameState(0, state.state(), state.structure(), List.of(),
                List.of("blew up at t = 1 s", "slow motion"));
        List<Rectangle2D> boxes = text.boxes(blownUp, true);
        BufferedImage with = onRed(text, blownUp);
        assertEquals(usual.size() + 2, boxes.size());
        for (Rectangle2D box : boxes) {
            int rgb = ground(with, box);
            assertTrue((rgb & 255) > 180, "light, as words are dark: " + Integer.toHexString(rgb));
        }
    }

    /** Frames of an atom come 1e17 times a second: the time has three digits. */
    @Test
    void theTimeOfAnAtomHasAnExponent() {
        FrameSetup setup = new FrameSetup(FRONT, RenderOptions.STANDARD, Scenery.NONE, "A title", "rk4");
        FrameState state = state(1.234e-16, List.of(), SpringList.NONE);
        assertEquals("1.23e-16", new FrameText(setup, W, H, 17).seconds(state));
        assertEquals("0.00", new FrameText(setup, W, H, 2).seconds(state));
    }

    private static int ground(BufferedImage picture, Rectangle2D box) {
        return picture.getRGB((int) box.getX() - 3, (int) box.getCenterY());
    }
}
