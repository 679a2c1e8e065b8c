package particles.reactions;

import deSolvers.ForceDerivatives;
import java.util.Arrays;
import particles.law.Particles;

/**
 * The contact forces of all particles that touch surfaces and are not coupled, in one loop over arrays. On one surface
 * the slides' closed form needs no system of equations: a cloth of 900 particles draped over a ball has hundreds of
 * such contacts, each of which should cost about as much as a spring, some nanoseconds. Particles on several surfaces
 * are {@link Block}s.
 */
final class LoneContacts {
    /** In place of a surface: the particle sticks, so that the total force on it is 0. */
    private static final int STICKS = -1;
    /** In place of a surface: the particle slides on several. */
    private static final int SEVERAL = -2;

    private final Blocks blocks;
    private final RestingContacts contacts;
    private final ContactModes modes;
    private final Particles particles;
    private int[] touching = {};
    private int[] surface = {};                         // that each of these particles slides on
    private int count;
    private int gatheredAt = -1;                        // the modes' and the rows' counts of changes
    private double[] total = {};

    LoneContacts(Blocks blocks, RestingContacts contacts, Particles particles) {
        this.blocks = blocks;
        this.contacts = contacts;
        this.modes = contacts.getModes();
        this.particles = particles;
    }

    private void gather() {
        int changes = modes.getChanges() + blocks.getRows().getChanges();
        if (gatheredAt == changes) {
            return;
        }
        gatheredAt = changes;
        count = 0;
        if (touching.length < modes.end()) {
            touching = new int[modes.end()];
            surface = new int[modes.end()];
        }
        for (int i = 0; i < modes.end(); i++) {
            if (modes.isTouching(i) && !particles.isFixed(i) && !blocks.isCoupled(i)) {
                touching[count] = i;
                int only = modes.only(i);
                surface[count++] = modes.isSticking(i) ? STICKS : only >= 0 ? only : SEVERAL;
            }
        }
    }

    /** Adds the contact forces to those of all effects (N); returns the power of friction (W). */
    double addForces(double[] state, double time, double[] force) {
        gather();
        blocks.prepare(state, time);
        double power = 0;
        for (int k = 0; k < count; k++) {
            power += add(k, state, time, force);
        }
        return power;
    }

    private double add(int k, double[] state, double time, double[] force) {
        int i = touching[k];
        if (surface[k] == SEVERAL) {
            return blocks.addForces(blocks.of(i), state, time, force, row -> row.frictionPower(state));
        }
        if (surface[k] == STICKS) {
            Arrays.fill(force, Particles.STRIDE * i + 3, Particles.STRIDE * (i + 1), 0.0);
            return 0;
        }
        return contacts.getSliding().addAlone(i, particles.mass(i), contacts.getSurfaces().get(surface[k]),
                !contacts.isHolding(), state, force);
    }

    /** The power of friction on these particles (W). */
    double power(double[] state, double time, double[] force) {
        total = total.length == force.length ? total : new double[force.length];
        System.arraycopy(force, 0, total, 0, force.length);
        return addForces(state, time, total);
    }

    /** Turns the derivatives of the forces so far (N) into those of the total forces. */
    void addForceDerivatives(double[] state, double time, double[] force, ForceDerivatives derivatives) {
        gather();
        blocks.prepare(state, time);
        ContactDerivative derivative = new ContactDerivative();
        for (int k = 0; k < count; k++) {
            int contact = k;
            int i = touching[k];
            SlidingFriction sliding = contacts.getSliding();
            derivative.add(i, sliding.neighbour(i), Math.max(contacts.curvature(i, state), sliding.turning(i, state)),
                    sum -> add(contact, state, time, sum), state, force, derivatives);
        }
    }
}
