package particles.reactions;

import java.util.function.IntToDoubleFunction;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Require;
import particles.law.Vector3;

/**
 * A plane or sphere that particles bounce off, rest on and slide along.
 *
 * @param name     its name in messages
 * @param obstacle its geometry
 * @param bounce   the law of its impacts
 * @param friction the friction of particles in contact
 * @param radius   the radius of each particle, which touches with its own surface (m); 0 for a point
 */
public record ContactSurface(String name, Obstacle obstacle, Bounce bounce, Friction friction,
        IntToDoubleFunction radius) {

    /**
     * The law of an impact of a particle with a surface or with another ball. A speed of approach v becomes the speed
     * of separation r v; friction changes the velocity across by at most mu times what the impact changes along the
     * normal.
     *
     * @param restitution r, 0 ... 1
     * @param friction    mu, 0 or more
     * @param restSpeed   what would separate more slowly stays in contact (m/s), 0 or more; 0 if r is 1, since then no
     *                    energy is lost
     */
    public record Bounce(double restitution, double friction, double restSpeed) {
        /** @throws IllegalArgumentException if a number is out of its range */
        public Bounce {
            if (!(restitution >= 0 && restitution <= 1)) {
                throw new IllegalArgumentException("the restitution has to be in 0 ... 1, not " + restitution);
            }
            Require.notNegative("the friction of impacts", friction);
            restSpeed = restitution == 1 ? 0 : Require.notNegative("the rest speed", restSpeed);
        }

        /** The speed of separation after an approach with a speed (m/s). */
        double leaving(double approach) {
            double leaving = restitution * approach;
            return leaving > restSpeed ? leaving : 0;
        }
    }

    /**
     * The friction of a surface: law, coefficients and threshold.
     *
     * @param law               the law of sliding friction
     * @param coefficient       k_f of {@link Law#SLIDE} (s/m), or mu of {@link Law#COULOMB} (a pure number); 0 or more
     * @param staticCoefficient the largest tangential force a particle at rest withstands, as a multiple of the normal
     *                          force; 0 for none
     * @param threshold         the speed below which a sliding particle may stick (m/s), 0 or more
     */
    public record Friction(Law law, double coefficient, double staticCoefficient, double threshold) {

        /** The laws a scene can name. */
        public enum Law {
            /** No friction. */
            NONE,
            /**
             * The lecture's law, with the sign that dissipates: for N . F &lt; 0 the contact force is
             * -(N . F)(N - k_f v_t). (The slide prints N + k_f v_t, which would push along the sliding.)
             */
            SLIDE,
            /** Coulomb's law: the tangential force is mu times the normal force, against the sliding. */
            COULOMB,
        }

        /** A surface without friction. */
        public static final Friction NONE = new Friction(Law.NONE, 0, 0, 0);

        /**
         * @param push the normal force (N)
         * @return the largest sliding friction by Coulomb's law (N); 0 by any other law
         */
        public double ofCoulomb(double push) {
            return law == Law.COULOMB ? coefficient * Math.max(0, push) : 0;
        }

        /** @throws IllegalArgumentException if a number is out of its range */
        public Friction {
            Require.notNegative("the coefficient of friction", coefficient);
            Require.notNegative("the coefficient of static friction", staticCoefficient);
            Require.notNegative("the threshold of friction", threshold);
        }
    }

    /**
     * A surface that particles touch as points; its friction acts at impacts too.
     *
     * @throws IllegalArgumentException if a number is out of its range
     */
    public ContactSurface(String name, Obstacle obstacle, double restitution, Friction friction, double restSpeed) {
        this(name, obstacle, new Bounce(restitution, friction.ofCoulomb(1), restSpeed), friction, i -> 0);
    }

    /** @return the distance of a particle's own surface from the surface (m), negative inside */
    public double distance(double[] state, int particle) {
        return obstacle.distance(state, Particles.STRIDE * particle) - radius.applyAsDouble(particle);
    }

    /** @return the normal at a particle, of length 1 */
    public Vector3 normal(double[] state, int particle) {
        return obstacle.normal(state, Particles.STRIDE * particle);
    }

    /** @return the size of the curvature at a particle (1/m), 0 for a plane */
    public double curvature(double[] state, int particle) {
        return Math.abs(obstacle.curvature(state, Particles.STRIDE * particle));
    }

    /** @return the component of a particle's velocity along the normal (m/s), negative inwards */
    public double normalSpeed(double[] state, int particle) {
        return normal(state, particle).dot(Vector3.at(state, Particles.STRIDE * particle + 3));
    }
}
