package particles.output.frames;

import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.H;
import static particles.output.SmallPictures.W;
import static particles.output.SmallPictures.count;
import static particles.output.SmallPictures.plain;
import static particles.output.SmallPictures.renderer;
import static particles.output.SmallPictures.spring;

import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;
import particles.output.painters.DrawnSizes;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.output.painters.FrameState.TrailSample;
import particles.output.raster.CameraProjection;
import particles.view.ParticleStyle;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.RenderOptions;
import particles.view.Scenery;

/** Particles with a colour, a size and a label of their own, and arrows, in pictures of 20 pixels a metre. */
class FrameMarksTest {
    private static final double RADIUS = 1;

    private static ParticleStyle style(double arrows, ParticleMark... marks) {
        return new ParticleStyle(ParticleStyle.Kind.BALLS, ParticleStyle.STANDARD.ageColours(), 0, false, arrows,
                List.of(marks));
    }

    private static FrameState state(ParticleStyle style, double x) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("plain", 1, new Vector3(-4, 0, 0), Vector3.ZERO, false);
        system.addParticle("marked", 1, new Vector3(x, 0, 0), new Vector3(3, 0, 0), false);
        return new FrameState(0, system.getOwnState(), FrameStructure.of(system, style.marks()), List.of(), List.of());
    }

    private static int[] picture(ParticleStyle style) {
        return renderer(FRONT, plain(0x0000ff, RADIUS, style), Scenery.NONE).render(state(style, 2));
    }

    private static boolean isRed(int rgb) {
        return (rgb >> 16 & 255) > 60 + (rgb & 255);
    }

    private static boolean isBlue(int rgb) {
        return (rgb & 255) > 90 + (rgb >> 8 & 255);
    }

    /** Discs of radius 20 and 40 pixels; the highlight in the middle and the edges, some per cent, are neither. */
    @Test
    void aMarkedParticleHasItsOwnColourAndSize() {
        int[] picture = picture(style(0, new ParticleMark("marked", Optional.of(0xff0000), 2 * RADIUS, "")));
        double disc = Math.PI * 20 * 20;
        assertEquals(disc, count(picture, FrameMarksTest::isBlue), 0.1 * disc);
        assertEquals(4 * disc, count(picture, FrameMarksTest::isRed), 0.4 * disc);
        assertEquals(0, count(picture(style(0)), FrameMarksTest::isRed));
    }

    /** From the middle of the ball at x = 2 m, pixel 200, 3 m/s for 0.8 s: 48 pixels. */
    @Test
    void anArrowIsAsLongAsTheWayInItsTime() {
        int[] picture = picture(style(0.8));
        int last = 0;
        for (int p = 0; p < picture.length; p++) {
            boolean green = (picture[p] >> 8 & 255) > 60 + (picture[p] >> 16 & 255) && !isBlue(picture[p]);
            last = green ? Math.max(last, p % W) : last;
        }
        assertEquals(248, last, 2);             // the tip itself is narrower than a pixel
    }

    @Test
    void aLabelStandsBesideItsParticleAndInThePicture() {
        ParticleStyle style = style(0, new ParticleMark("marked", Optional.empty(), 0, "a label"));
        FrameMarks marks = new FrameMarks(new CameraProjection(FRONT, W, H), RenderOptions.STANDARD.withStyle(style));
        Rectangle2D right = marks.boxes(state(style, 2), RADIUS).get(0);
        assertBetween(220, 230, right.getMinX());   // the ball ends at 220
        assertTrue(right.getMinY() < 100 && right.getMaxY() > 100, right.toString());
        Rectangle2D left = marks.boxes(state(style, 6.8), RADIUS).get(0);
        assertTrue(left.getMaxX() < 160 + 20 * 5.8 && left.getMinX() > 0, left.toString());
    }

    /** Two balls, 40 pixels wide and 20 to 180 apart, with labels of 60 pixels and more. */
    @Test
    void labelsOfNeighboursStandClearOfEachOtherAndOfTheBalls() {
        ParticleStyle style = style(0, new ParticleMark("marked", Optional.empty(), 0, "a long label"),
                new ParticleMark("plain", Optional.empty(), 0, "another one"));
        FrameMarks marks = new FrameMarks(new CameraProjection(FRONT, W, H), RenderOptions.STANDARD.withStyle(style));
        for (double x = -3; x <= 5; x++) {
            List<Rectangle2D> boxes = marks.boxes(state(style, x), RADIUS);
            assertEquals(2, boxes.size());
            assertFalse(boxes.get(0).intersects(boxes.get(1)), "x = " + x + ": " + boxes);
            for (double ball : new double[] {-4, x}) {
                Rectangle2D disc = new Rectangle2D.Double(140 + 20 * ball, 80, 40, 40);
                assertTrue(boxes.stream().noneMatch(disc::intersects), "x = " + x + ": " + boxes);
            }
        }
    }

    /**
     * A spring from the middle of the picture to a ball that goes round it, or a ball in the middle that came from the
     * right, or from any other direction.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aLabelStandsClearOfTheSpringAndTheTrailOfItsBall(boolean spring) {
        ParticleStyle style = style(0, new ParticleMark("marked", Optional.empty(), 0, "a label"));
        FrameMarks marks = new FrameMarks(new CameraProjection(FRONT, W, H), RenderOptions.STANDARD.withStyle(style));
        for (int k = 0; k < 24; k++) {
            double x = 3.5 * Math.cos(Math.PI * k / 12);
            double y = 3.5 * Math.sin(Math.PI * k / 12);
            FrameStructure marked = state(style, 0).structure();
            FrameState state;
            if (spring) {
                FrameState one = spring(1, 1, 0, 0, 0, x, y, 0);
                state = new FrameState(0, one.state(), new FrameStructure(marked.ids(), marked.fixed(), one.springs(),
                        marked.births(), marked.deaths(), marked.marks()), List.of(), List.of());
            } else {
                state = new FrameState(0, new double[12], marked, List.of(
                        new TrailSample(1, new float[6], marked.ids()),
                        new TrailSample(0, new float[] {0, 0, 0, (float) x, (float) y, 0}, marked.ids())), List.of());
            }
            Rectangle2D box = marks.boxes(state, RADIUS / 2).get(0);
            assertFalse(box.intersectsLine(160, 100, 160 + 20 * x, 100 - 20 * y), "place " + k + ": " + box);
        }
    }

    /** 41 springs are too many for coils, but a hundred times softer than the others is told from them. */
    @Test
    void softSpringsAmongManyStiffOnesAreCoils() {
        assertEquals(1, coils(41, 99));
        assertEquals(0, coils(41, 101));
        assertEquals(40, coils(40, 101), "few springs are all coils");
    }

    /** A chain with one spring of its own stiffness among others of 10,000 N/m; how many coils are there? */
    private static long coils(int count, double soft) {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        for (int i = 0; i <= count; i++) {
            system.addParticle("p" + i, 1, new Vector3(i, 0, 0), Vector3.ZERO, false);
        }
        for (int i = 0; i < count; i++) {
            springs.addSpring(i, i + 1, i == 7 ? soft : 10_000, 1, 0);
        }
        system.addEffect(springs);
        FrameState state = new FrameState(0, system.getOwnState(), FrameStructure.of(system, List.of()), List.of(),
                List.of());
        double below = DrawnSizes.of(state, RenderOptions.STANDARD, 10).coilBelow();
        return springs.springCount() == count ? IntStream.range(0, count)
                .filter(s -> state.springs().stiffness()[s] < below).count() : -1;
    }
}
