package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.law.Particles;
import particles.law.Plane;

/** Removes particles that are behind a plane at the end of a step, such as the drain of a fountain. */
public final class KillPlane implements Rule {
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
    public boolean afterStep(ParticleSystem system, double deltaT) {
        return Deaths.remove(system, (s, i) -> isBehind(s.getOwnState(), i) && !s.getParticles().isFixed(i));
    }

    private boolean isBehind(double[] state, int i) {
        int x = Particles.STRIDE * i;
        return plane.distance(state[x], state[x + 1], state[x + 2]) < 0;
    }
}
