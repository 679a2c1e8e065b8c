package particles.reactions;

import particles.law.Require;

/**
 * The law of an impact of a particle with a surface or with another ball. A speed of approach v becomes the speed of
 * separation r v; friction changes the velocity across by at most mu times what the impact changes along the normal.
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
