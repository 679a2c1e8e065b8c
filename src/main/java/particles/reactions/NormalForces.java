package particles.reactions;

import java.util.Arrays;
import java.util.BitSet;
import particles.law.Particles;
import particles.law.Scales.Skin;
import particles.law.Vector3;

/** Solves for the normal forces on one particle under a known force, without friction. */
final class NormalForces {
    private static final BitSet NOBODY = new BitSet();

    /**
     * The normal force of a surface on a particle.
     *
     * @param normal     of the surface
     * @param size       the force (N), negative if it pulls
     * @param separation the force that pulls the particle off (N), if nothing pushes it on
     */
    record Push(ContactSurface surface, Vector3 normal, double size, double separation) {
    }

    private final Contacts contacts;
    private final GatherPhase gather;
    private final EvaluatePhase evaluate;
    final SolvePhase solve;

    NormalForces(SolvePhase solve) {
        this.solve = solve;
        contacts = solve.contacts;
        gather = solve.gather;
        evaluate = solve.evaluate;
    }

    /**
     * The normal forces of all surfaces that a particle touches.
     *
     * @param signed whether they can only push
     */
    Push[] find(int i, double[] state, double[] force, boolean signed) {
        int only = contacts.getModes().only(i);
        if (only >= 0) {
            ContactSurface surface = contacts.getSurfaces().get(only);
            Vector3 normal = surface.normal(state, i);
            double push = SlidingFriction.push(normal, i, contacts.particles.mass(i), surface, state, force);
            return new Push[] {new Push(surface, normal, signed ? Math.max(0, push) : push, -Math.min(0, push))};
        }
        Block alone = gather.alone(i);
        gather.gather(alone, NOBODY, false);
        evaluate.evaluate(alone, state);
        for (Row row : alone.rows) {
            row.right = -(row.times(force, 3) + row.bend);
        }
        solve.solve(alone, row -> true, signed);
        return Arrays.stream(alone.rows).map(row -> new Push(row.surface, Vector3.at(row.gradient, 0), row.force,
                row.separation)).toArray(Push[]::new);
    }

    /** The margin of a particle under a known force: of its contacts' static friction over the force along them (N). */
    double margin(int i, double[] state, double[] force) {
        Vector3 rest = Vector3.at(force, Particles.STRIDE * i + 3);
        double withstood = 0;
        double pushed = 0;
        Push[] pushes = find(i, state, force, true);
        for (Push push : pushes) {
            pushed += push.size();
            withstood += push.size() * push.surface().friction().staticCoefficient();
            rest = rest.plus(push.normal().times(push.size()));
        }
        return pushed > 0 ? withstood - skin(i, state, pushes).toHold(rest) : -1;
    }

    /** The skin of a particle along all surfaces that push it. */
    Skin skin(int i, double[] state, Push... pushes) {
        if (contacts.scalesOf(i).isEmpty()) {           // the same along all normals
            return Skin.SMOOTH;
        }
        return evaluate.sliding.skin(i, state, Arrays.stream(pushes).filter(push -> push.size() > 0).map(Push::normal)
                .toArray(Vector3[]::new));
    }
}
