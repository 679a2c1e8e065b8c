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
