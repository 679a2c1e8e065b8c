package particles.rules;

import particles.law.AnchorMotion;
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
        if (!centre.isFinite() || !amplitude.isFinite() || !(period > 0) || !(period <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException(
                    "an oscillation needs a finite centre and amplitude and a positive period,"
                    + " not " + centre + ", " + amplitude + ", " + period);
        }
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
