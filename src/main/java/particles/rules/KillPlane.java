package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.law.Particles;
import particles.law.Plane;

/** Particles that are behind a plane at the end of a step are gone: the drain of a fountain, the end of the world. */
public final class KillPlane implements Rule {
    private final Plane plane;

    /** @param plane those on the side away from its normal go; fixed ones stay */
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
