package particles.reactions;

import java.util.ArrayList;
import java.util.List;
import particles.law.Particles;

/**
 * The contact forces of particles that slide on one surface each and are not coupled. The slides' closed form needs no
 * system of equations: on a cloth of 900 particles draped over a ball that took most of the time of a step.
 */
final class LoneContacts {
    private final RestingContacts contacts;
    private final ContactModes modes;
    private final Particles particles;

    LoneContacts(RestingContacts contacts, Particles particles) {
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.particles = particles;
    }

    /** Whether a block is such a particle. */
    boolean handles(Block block) {
        return !block.isJoined() && modes.only(block.particles[0]) >= 0 && !modes.isSticking(block.particles[0]);
    }

    /** Adds the contact force of such a particle to that of all effects (N); returns the power of friction (W). */
    double add(Block block, double[] state, double[] force) {
        int i = block.particles[0];
        return contacts.getSliding().addAlone(i, particles.mass(i), contacts.getSurfaces().get(modes.only(i)),
                !contacts.isHolding(), state, force);
    }

    /** The power of friction on all particles of some blocks (W), each of which is one particle. */
    double power(Blocks blocks, List<Block> some, double[] state, double time, double[] force) {
        double[] total = force.clone();
        double sum = 0;
        List<Block> others = new ArrayList<>();
        for (Block block : some) {
            if (handles(block)) {
                sum += add(block, state, total);
            } else {
                others.add(block);
            }
        }
        return sum + blocks.power(others, state, time, force, row -> row.frictionPower(state));
    }
}
