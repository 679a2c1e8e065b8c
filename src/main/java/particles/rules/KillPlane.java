package particles.rules;

import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Plane;

/** Removes particles that are behind a plane at the end of a step, such as the drain of a fountain. */
public final class KillPlane extends Deaths {
    private final Plane plane;

    /** @param plane free particles on the side away from its normal are removed */
    public KillPlane(Plane plane) {
        this.plane = plane;
    }

    @Override
    public String getName() {
        return "kill";
    }

    @Override
    boolean goes(ParticleSystem system, int i) {
        double[] state = system.getOwnState();
        int x = Particles.STRIDE * i;
        return plane.distance(state[x], state[x + 1], state[x + 2]) < 0 && !system.getParticles().isFixed(i);
    }
}
