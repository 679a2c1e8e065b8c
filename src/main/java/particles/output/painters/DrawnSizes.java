package particles.output.painters;

import java.util.Arrays;
import java.util.stream.IntStream;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;

/**
 * The drawn sizes of balls and springs, decided at the first frame; by default balls are small enough to be told apart.
 *
 * @param ball      the radius of a ball (m)
 * @param coilBelow springs of less than this stiffness (N/m) are drawn as coils: all of them if there are few,
 *                  otherwise those that are far softer than the others
 * @param point     the radius of a point (m)
 */
public record DrawnSizes(double ball, double coilBelow, double point) {
    private static final int MOST_COILS = 40;
    /** The fraction of the stiffest spring's stiffness below which a spring is far softer. */
    private static final double SOFT = 0.01;
    private static final double PART_OF_PICTURE = 0.028;
    private static final double POINT = 0.0026;
    private static final double PART_OF_SPRING = 0.26;
    /** Fraction of the spacing of particles spread evenly over a cube as high as the picture. */
    private static final double PART_OF_DISTANCE = 0.3;

    /** Chooses the sizes for a frame; viewHeight is the height of the picture at the target (m). */
    public static DrawnSizes of(FrameState state, RenderOptions look, double viewHeight) {
        double mean = Arrays.stream(state.springs().restLength()).average().orElse(0);
        double ball = viewHeight * Math.min(PART_OF_PICTURE,
                PART_OF_DISTANCE / Math.cbrt(Math.max(1, state.particles())));
        if (mean > 0) {
            ball = Math.min(ball, PART_OF_SPRING * mean);
        }
        return new DrawnSizes(look.particleRadius() > 0 ? look.particleRadius() : ball, coilBelow(state),
                POINT * viewHeight);
    }

    /** @return the distance by which a particle at rest on a plane extends below its centre (m) */
    public double reach(FrameState state, RenderOptions look, VisibilityFilter shown) {
        ParticleStyle.Kind kind = look.style().kind();
        boolean thick = kind == ParticleStyle.Kind.BALLS || kind == ParticleStyle.Kind.BLOBS;
        return thick && IntStream.range(0, state.particles()).anyMatch(shown::particle) ? ball : point;
    }

    private static double coilBelow(FrameState state) {
        double[] stiffness = state.springs().stiffness();
        if (stiffness.length <= MOST_COILS) {
            return Double.POSITIVE_INFINITY;
        }
        double soft = SOFT * Arrays.stream(stiffness).filter(Double::isFinite).max().orElse(0);
        return Arrays.stream(stiffness).filter(one -> one > 0 && one < soft).count() <= MOST_COILS ? soft : 0;
    }

    /** @return whether spring s is drawn as a coil, not as a straight tube */
    boolean isCoil(FrameState state, int s) {
        return coilBelow == Double.POSITIVE_INFINITY || state.springs().stiffness()[s] < coilBelow;
    }

    /** @return the radius of a fixed particle among glowing ones, whose spots of light are larger (m) */
    double core() {
        return ball / 3;
    }

    /** @return the radius of a spring of this stiffness drawn as a straight tube (m): rods are thick, lines thin */
    public double tube(double stiffness) {
        return stiffness == 0 ? railing() : stiffness == Double.POSITIVE_INFINITY ? rod() : 0.3 * ball;
    }

    /** @return the radius of the wire that a bead slides along (m) */
    double railing() {
        return 0.2 * ball;
    }

    /** @return the radius of a rigid rod (m) */
    double rod() {
        return 0.34 * ball;
    }

    /** @return the radius of a coil (m) */
    double coil() {
        return 0.62 * ball;
    }

    /** @return the radius of its wire (m) */
    double wire() {
        return 0.13 * ball;
    }
}
