package particles.reactions;

import particles.law.Require;

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
