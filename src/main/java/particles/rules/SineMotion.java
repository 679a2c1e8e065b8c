package particles.rules;

import particles.law.AnchorMotion;
import particles.law.Vector3;

/** Sinusoidal motion of an anchor, as of a hand that shakes a spring: x = centre + amplitude sin(2 pi t / period). */
public final class SineMotion implements AnchorMotion {
    private final double[] centre;
    private final double[] amplitude;
    private final double omega;

    /**
     * @param centre    the centre (m)
     * @param amplitude the vector from the centre to the end point (m)
     * @param period    the period (s), positive
     * @throws IllegalArgumentException if the period is not positive or a number not finite
     */
    public SineMotion(Vector3 centre, Vector3 amplitude, double period) {
        if (!centre.isFinite() || !amplitude.isFinite() || !(period > 0) || !(period <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException(
                    "an oscillation needs a finite centre and amplitude and a positive period,"
                    + " not " + centre + ", " + amplitude + ", " + period);
        }
        this.centre = new double[] {centre.x(), centre.y(), centre.z()};
        this.amplitude = new double[] {amplitude.x(), amplitude.y(), amplitude.z()};
        omega = 2 * Math.PI / period;
    }

    @Override
    public void at(double time, double[] values) {
        double sin = StrictMath.sin(omega * time);
        double cos = StrictMath.cos(omega * time);
        for (int c = 0; c < 3; c++) {
            values[c] = centre[c] + amplitude[c] * sin;
            values[3 + c] = amplitude[c] * omega * cos;
            values[6 + c] = -amplitude[c] * omega * omega * sin;
        }
    }
}
