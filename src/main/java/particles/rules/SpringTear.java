package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.effects.springs.SpringForce;
import particles.law.Require;

/**
 * Tearing of overstretched springs: at the end of a step a spring longer than (1 + strain) times its rest length is
 * removed, and the energy it stored is lost. Springs of rest length 0 have no strain and never tear.
 */
public final class SpringTear implements Rule {
    private final SpringForce springs;
    private final double strain;

    /**
     * @param springs the springs
     * @param strain  the largest strain (extension/rest length) before a spring tears, positive
     * @throws IllegalArgumentException if the strain is out of its range
     */
    public SpringTear(SpringForce springs, double strain) {
        this.springs = springs;
        this.strain = Require.positive("the strain at which springs tear", strain);
    }

    @Override
    public String getName() {
        return "tear";
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        double[] state = system.getOwnState();
        boolean[] gone = new boolean[springs.springCount()];
        boolean any = false;
        for (int s = 0; s < gone.length; s++) {
            gone[s] = isTorn(state, s);
            any |= gone[s];
        }
        if (any) {
            springs.removeSprings(gone);
        }
        return any;
    }

    private boolean isTorn(double[] state, int s) {
        double restLength = springs.restLength(s);
        return restLength > 0 && springs.length(state, s) > (1 + strain) * restLength;
    }
}
