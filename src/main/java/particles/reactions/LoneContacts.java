package particles.reactions;

import deSolvers.ForceDerivatives;
import java.util.Arrays;
import java.util.Optional;
import particles.law.Particles;
import particles.law.Scales;
import particles.law.Vector3;
import particles.reactions.ContactDerivative.Push;

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
    private static final double[] NONE = new double[9];

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
        double[][] matrices = new double[4][9];         // by force, place, velocity and the neighbour's place
        for (int k = 0; k < count; k++) {
            int i = touching[k];
            SlidingFriction sliding = contacts.getSliding();
            Optional<Scales> scales = sliding.scalesOf(i);
            int end = scales.map(s -> s.head() == i ? 1 : -1).orElse(0);     // how its place enters the body's axis
            ContactDerivative derivative = new ContactDerivative(sliding, i, particles.mass(i), state,
                    Vector3.at(force, Particles.STRIDE * i + 3), pushes(k, state, time, force));
            for (int c = 0; c < 3; c++) {
                Vector3 unit = new Vector3(c == 0 ? 1 : 0, c == 1 ? 1 : 0, c == 2 ? 1 : 0);
                Vector3 body = unit.times(end);
                Vector3[] columns = {derivative.change(unit, Vector3.ZERO, Vector3.ZERO, Vector3.ZERO),
                    derivative.change(Vector3.ZERO, unit, Vector3.ZERO, body),
                    derivative.change(Vector3.ZERO, Vector3.ZERO, unit, Vector3.ZERO),
                    derivative.change(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO, body.times(-1))};
                for (int m = 0; m < columns.length; m++) {
                    Vector3 column = surface[k] == STICKS ? Vector3.ZERO : columns[m];
                    matrices[m][c] = column.x();
                    matrices[m][3 + c] = column.y();
                    matrices[m][6 + c] = column.z();
                }
            }
            derivatives.transformRow(i, matrices[0]);
            derivatives.add(i, i, matrices[1], matrices[2]);
            scales.ifPresent(s -> derivatives.add(i, s.tail() + s.head() - i, matrices[3], NONE));
        }
    }

    /** The normal forces on a particle. */
    private Push[] pushes(int k, double[] state, double time, double[] force) {
        int i = touching[k];
        if (surface[k] == SEVERAL) {
            Vector3 before = Vector3.at(force, Particles.STRIDE * i + 3);
            add(k, state, time, force);
            before.put(force, Particles.STRIDE * i + 3);
            return Arrays.stream(blocks.of(i).rows).filter(row -> row.force != 0)
                    .map(row -> new Push(row.surface, Vector3.at(row.gradient, 0), row.force)).toArray(Push[]::new);
        }
        if (surface[k] == STICKS) {
            return new Push[0];
        }
        ContactSurface only = contacts.getSurfaces().get(surface[k]);
        Vector3 normal = only.normal(state, i);
        double push = SlidingFriction.push(normal, i, particles.mass(i), only, state, force);
        return push > 0 || contacts.isHolding() ? new Push[] {new Push(only, normal, push)} : new Push[0];
    }
}
