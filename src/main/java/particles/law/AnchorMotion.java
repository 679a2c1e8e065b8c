package particles.law;

/** The prescribed motion of a moving anchor: a shaken hand, a turning crank. */
public interface AnchorMotion {
    /**
     * Writes the position, velocity and acceleration of the anchor at a time.
     *
     * @param time   t (s)
     * @param values receives nine numbers: position (m), its first derivative (m/s) and its second (m/s&sup2;)
     */
    void at(double time, double[] values);

    /**
     * Returns the shortest time in which the anchor may go somewhere and come back.
     *
     * @param time t (s)
     * @return the period of the motion, or what is left of one that ends (s); infinite by default
     */
    default double getShortestTime(double time) {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * Sinusoidal motion of an anchor, as of a hand that shakes a spring: x = centre + amplitude sin(2 pi t / period).
     *
     * @param centre    the centre (m)
     * @param amplitude the vector from the centre to the end point (m)
     * @param period    the period (s), positive
     */
    record SineMotion(Vector3 centre, Vector3 amplitude, double period) implements AnchorMotion {
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

        @Override
        public double getShortestTime(double time) {
            return period;
        }
    }

    /** Uniform motion of an anchor on a circle, as of a crank: counter-clockwise when the axis points at the viewer. */
    final class CircleMotion implements AnchorMotion {
        private final Vector3 centre;
        private final Vector3 cosine;
        private final Vector3 sine;
        private final double omega;

        /**
         * @param start  the position at t = 0 (m)
         * @param centre any point of the axis (m)
         * @param axis   its direction
         * @param period the time of one turn (s), not 0; a negative one turns the other way
         * @throws IllegalArgumentException if the axis has no direction, the period is 0 or a number not finite
         */
        public CircleMotion(Vector3 start, Vector3 centre, Vector3 axis, double period) {
            Vector3 unit = axis.normalized();
            Vector3 radius = start.minus(centre).requireFinite("the radius of a circle");
            Vector3 along = unit.times(radius.dot(unit));
            this.centre = centre.plus(along);
            cosine = radius.minus(along);
            sine = unit.cross(cosine);
            omega = 2 * Math.PI / (Math.signum(period) * Require.positive("the length of a period", Math.abs(period)));
        }

        @Override
        public void at(double time, double[] values) {
            double sin = StrictMath.sin(omega * time);
            double cos = StrictMath.cos(omega * time);
            Vector3 from = cosine.times(cos).plus(sine.times(sin));
            from.plus(centre).put(values, 0);
            sine.times(cos).minus(cosine.times(sin)).times(omega).put(values, 3);
            from.times(-omega * omega).put(values, 6);
        }

        @Override
        public double getShortestTime(double time) {
            return 2 * Math.PI / Math.abs(omega);
        }
    }

    /**
     * Smooth motion of an anchor along a straight line: the fraction covered is s = u&sup3; (10 - 15 u + 6 u&sup2;)
     * with u = t/duration, so that velocity and acceleration are 0 at both ends. Afterwards the anchor stays.
     *
     * <p>Source: T. Flash, N. Hogan, "The coordination of arm movements" (1985): the minimum-jerk motion.
     *
     * @param from     the position at t = 0 (m)
     * @param to       the position at the end (m)
     * @param duration the duration of the motion (s), positive
     */
    record GlideMotion(Vector3 from, Vector3 to, double duration) implements AnchorMotion {
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

        @Override
        public double getShortestTime(double time) {
            return time < duration ? duration : Double.POSITIVE_INFINITY;
        }
    }
}
