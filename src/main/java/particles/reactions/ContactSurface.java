package particles.reactions;

import java.util.function.IntToDoubleFunction;
import particles.law.Obstacle;
import particles.law.Particles;
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
