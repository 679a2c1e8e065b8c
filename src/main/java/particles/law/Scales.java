package particles.law;

/**
 * The scales of a snake or the bristles of a worm: a particle's friction depends on the direction in which it slides.
 * Its body's axis points from one particle to the next, which is nearer the head; forward, backward and across it,
 * Coulomb's mu is multiplied by three factors.
 *
 * <p>Without scales, the friction of a contact is any vector in a disc of radius mu lambda, where lambda is the normal
 * force. With scales that disc becomes two half ellipses: S<sup>-1</sup> f lies in the disc, where S multiplies the
 * part along the axis by the factor for the direction of motion that f resists, and the part across by the third
 * factor. Of these forces, that of sliding with v dissipates most, f = -mu lambda S&sup2; v / |S v|: its power, -mu
 * lambda |S v|, is never positive. (The principle and the set: S. Goyal, A. Ruina and J. Papadopoulos, "Planar
 * sliding with dry friction", Wear 143, 1991. Snakes: D. Hu, J. Nirody, T. Scott and M. Shelley, "The mechanics of
 * slithering locomotion", PNAS 106, 2009, with factors of 1, 1.3 and 1.8. They take -mu lambda S v / |v|, a force of
 * the same ellipses that takes less. G. Miller, "The motion dynamics of snakes and worms", SIGGRAPH 1988, lets nothing
 * slide backward.)
 *
 * <p>With the slides' friction, which is proportional to speed, S multiplies the velocity. A particle keeps its axis if
 * the spring to its neighbour tears, and loses its scales if the neighbour dies.
 *
 * @param tail     the index of the particle at which the axis begins
 * @param head     the index of the next particle
 * @param forward  factor for sliding along the axis, over 0
 * @param backward factor for sliding against the axis, over 0
 * @param across   factor for sliding across the axis, over 0
 */
public record Scales(int tail, int head, double forward, double backward, double across) {

    /** @throws IllegalArgumentException if a factor is out of its range */
    public Scales {
        Require.positive("the factor of friction forward", forward);
        Require.positive("the factor of friction backward", backward);
        Require.positive("the factor of friction across", across);
    }

    /** @return the vector along the body (m) */
    public Vector3 axis(double[] state) {
        return Vector3.at(state, Particles.STRIDE * head).minus(Vector3.at(state, Particles.STRIDE * tail));
    }

    /** @return the largest derivative of friction by the velocity, as a multiple of that without scales */
    public double sharpness() {
        return Math.max(sharpness(forward), sharpness(backward));
    }

    /** The largest curvature of the half ellipse with this factor along the axis. */
    private double sharpness(double along) {
        double largest = Math.max(along, across);
        return largest * largest / Math.min(along, across);
    }

    /**
     * Where the body's axis leaves the surface, the factors along it approach the one across.
     *
     * @param length the length of the vector along the body (m)
     * @param along  its part along the surfaces that the particle touches (m)
     * @return the skin on these surfaces
     */
    public Skin skin(double length, Vector3 along) {
        double part = length == 0 ? 0 : along.length() / length;
        double flat = part * part;
        return new Skin(part == 0 ? Vector3.ZERO : along.normalized(), across + flat * (forward - across),
                across + flat * (backward - across), across);
    }

    /**
     * The map S of a particle on surfaces, for vectors along these.
     *
     * @param axis     the direction of the body, of length 1 or 0
     * @param forward  factor along it
     * @param backward factor against it
     * @param across   factor across it
     */
    public record Skin(Vector3 axis, double forward, double backward, double across) {
        /** Without scales. */
        public static final Skin SMOOTH = new Skin(Vector3.ZERO, 1, 1, 1);
        private static final int MOST_ITERATIONS = 60;

        /** @return S u, for a velocity or a force that moves the particle */
        public Vector3 stretch(Vector3 u) {
            return this == SMOOTH ? u : scale(u, ahead(u), across);
        }

        /** @return the factor along the axis for a vector */
        public double ahead(Vector3 u) {
            return axis.dot(u) < 0 ? backward : forward;
        }

        /** @return a vector with its part along the axis and that across multiplied by a factor each */
        public Vector3 scale(Vector3 u, double ahead, double aside) {
            double along = axis.dot(u);
            Vector3 rest = u.minus(axis.times(along));
            return rest.times(aside).plus(axis.times(ahead * along));
        }

        /** @return mu lambda (N) that is just enough to balance a force along the surfaces (N) */
        public double toHold(Vector3 force) {
            Vector3 shrunk = this == SMOOTH ? force : scale(force, 1 / ahead(force), 1 / across);
            return Math.sqrt(shrunk.dot(shrunk));
        }

        /**
         * Finds which part of a force is balanced: the admissible force nearest to it, with a minus sign. For an
         * ellipse with half axes e it is e&sup2; / (t + e&sup2;) times the force along each, with t from Newton's
         * method, which approaches it from below.
         *
         * @param force along the surfaces (N)
         * @param most  mu lambda (N)
         */
        public Vector3 balance(Vector3 force, double most) {
            double size = this == SMOOTH ? force.length() : toHold(force);
            if (size <= most) {
                return force;
            }
            if (this == SMOOTH || most <= 0) {
                return force.times(Math.max(0, most) / size);
            }
            double along = axis.dot(force);
            double a = most * ahead(force);
            double c = most * across;
            double x = a * along;
            double y = c * force.minus(axis.times(along)).length();
            double t = Math.max(0, Math.max(Math.abs(x) - a * a, y - c * c));
            double more = Double.POSITIVE_INFINITY;
            for (int k = 0; k < MOST_ITERATIONS && more > 0; k++) {
                double u = x / (t + a * a);
                double w = y / (t + c * c);
                double before = t;
                t += (u * u + w * w - 1) / 2 / (u * u / (t + a * a) + w * w / (t + c * c));
                more = t - before;
            }
            double part = a * a / (t + a * a);
            return scale(force, part, c * c / (t + c * c));
        }
    }
}
