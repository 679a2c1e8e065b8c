package particles.reactions.contact;

import particles.law.Obstacle;

/**
 * A plane or sphere that particles bounce off, rest on and slide along.
 *
 * @param name        its name in messages
 * @param obstacle    its geometry
 * @param restitution r: the normal component of the velocity is multiplied by -r at an impact; 0 ... 1
 * @param friction    its friction
 * @param restSpeed   a particle that would leave the surface slower than this stays in contact (m/s), 0 or more
 */
public record ContactSurface(String name, Obstacle obstacle, double restitution, Friction friction, double restSpeed) {
    /** @throws IllegalArgumentException if a number is out of its range */
    public ContactSurface {
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException("the restitution of '" + name + "' has to be in 0 ... 1, not "
                    + restitution);
        }
        if (!(restSpeed >= 0 && restSpeed <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("the rest speed of '" + name + "' has to be 0 or more and finite, not "
                    + restSpeed);
        }
    }
}
