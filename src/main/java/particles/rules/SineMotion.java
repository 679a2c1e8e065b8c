package particles.rules;

import particles.law.AnchorMotion;
import particles.law.Require;
import particles.law.Vector3;

/**
 * Sinusoidal motion of an anchor, as of a hand that shakes a spring: x = centre + amplitude sin(2 pi t / period).
 *
 * @param centre    the centre (m)
 * @param amplitude the vector from the centre to the end point (m)
 * @param period    the period (s), positive
 */
public record SineMotion(Vector3 centre, Vector3 amplitude, double period) implements AnchorMotion {
    /** @throws IllegalArgumentException if the period is not positive or a number not finite */
    public SineMotion {
        centre.requireFinite("the centre of an oscillation");
        amplitude.requireFinite("its amplitude");
        Require.positive("its period", period);
    }

    @Override
    public void at(double time, double[] values) {
        double omega = 2 * Math.PI / period;
        double sin = StrictMath.sin(omega * time);
        double cos = StrictMath.cos(omega * time);
        centre.plus(amplitude.times(sin)).put(values, 0);
        amplitude.times(omega).times(cos).put(values, 3);
        amplitude.times(omega).times(omega).times(-sin).put(values, 6);
    }
}
