package particles.rules;

import particles.law.AnchorMotion;
import particles.law.Require;
import particles.law.Vector3;

/**
 * Smooth motion of an anchor along a straight line: the fraction covered is s = u&sup3; (10 - 15 u + 6 u&sup2;) with u
 * = t/duration, so that velocity and acceleration are 0 at both ends. Afterwards the anchor stays.
 *
 * <p>Source: T. Flash, N. Hogan, "The coordination of arm movements" (1985): the minimum-jerk motion.
 *
 * @param from     the position at t = 0 (m)
 * @param to       the position at the end (m)
 * @param duration the duration of the motion (s), positive
 */
public record GlideMotion(Vector3 from, Vector3 to, double duration) implements AnchorMotion {
    /** @throws IllegalArgumentException if the duration is not positive or a number not finite */
    public GlideMotion {
        from.requireFinite("the beginning of a glide");
        to.requireFinite("its end");
        Require.positive("its duration", duration);
    }

    @Override
    public void at(double time, double[] values) {
        double u = Math.min(1, Math.max(0, time / duration));
        double part = u * u * u * (10 + u * (6 * u - 15));
        double rate = 30 * u * u * (1 - u) * (1 - u) / duration;
        double growth = 60 * u * (1 - u) * (1 - 2 * u) / (duration * duration);
        Vector3 way = to.minus(from);
        from.plus(way.times(part)).put(values, 0);
        way.times(rate).put(values, 3);
        way.times(growth).put(values, 6);
    }
}
