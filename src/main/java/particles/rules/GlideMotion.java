package particles.rules;

import particles.law.AnchorMotion;
import particles.law.Vector3;

/**
 * Smooth motion of an anchor along a straight line: the fraction covered is s = u&sup3; (10 - 15 u + 6 u&sup2;) with u
 * = t/duration, so that velocity and acceleration are 0 at both ends. Afterwards the anchor stays.
 *
 * <p>Source: T. Flash, N. Hogan, "The coordination of arm movements" (1985): the minimum-jerk motion.
 */
public final class GlideMotion implements AnchorMotion {
    private final double[] from;
    private final double[] way;
    private final double duration;

    /**
     * @param from     the position at t = 0 (m)
     * @param to       the position at the end (m)
     * @param duration the duration of the motion (s), positive
     * @throws IllegalArgumentException if the duration is not positive or a number not finite
     */
    public GlideMotion(Vector3 from, Vector3 to, double duration) {
        if (!from.isFinite() || !to.isFinite() || !(duration > 0) || !(duration <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("a glide needs finite places and a positive duration, not " + from
                    + ", " + to
                    + ", " + duration);
        }
        this.from = new double[] {from.x(), from.y(), from.z()};
        way = new double[] {to.x() - from.x(), to.y() - from.y(), to.z() - from.z()};
        this.duration = duration;
    }

    @Override
    public void at(double time, double[] values) {
        double u = Math.min(1, Math.max(0, time / duration));
        double part = u * u * u * (10 + u * (6 * u - 15));
        double rate = 30 * u * u * (1 - u) * (1 - u) / duration;
        double growth = 60 * u * (1 - u) * (1 - 2 * u) / (duration * duration);
        for (int c = 0; c < 3; c++) {
            values[c] = from[c] + part * way[c];
            values[3 + c] = rate * way[c];
            values[6 + c] = growth * way[c];
        }
    }
}
