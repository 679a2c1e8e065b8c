package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Vector3;

/** Removes particles at the end of a step. */
public final class Deaths implements Rule {
    private final String name;
    private final Test test;

    /** Selects the particles to remove. */
    private interface Test {
        boolean goes(ParticleSystem system, int i);
    }

    private Deaths(String name, Test test) {
        this.name = name;
        this.test = test;
    }

    /**
     * Removes particles that are behind a plane, such as the drain of a fountain.
     *
     * @param plane free particles on the side away from its normal are removed
     */
    public static Deaths behind(Plane plane) {
        return new Deaths("kill", (system, i) -> {
            double[] state = system.getOwnState();
            return plane.distance(Vector3.at(state, Particles.STRIDE * i)) < 0 && !system.getParticles().isFixed(i);
        });
    }

    /** Removes particles whose lifetime is over. Only emitted particles have a lifetime. */
    public static Deaths ofAge() {
        return new Deaths("age", (system, i) -> system.getParticles().deathTime(i) <= system.getTime());
    }

    @Override
    public String getName() {
        return name;
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        boolean[] gone = new boolean[system.getParticles().count()];
        boolean any = false;
        for (int i = 0; i < gone.length; i++) {
            gone[i] = test.goes(system, i);
            any |= gone[i];
        }
        if (any) {
            system.removeParticles(gone);
        }
        return any;
    }
}
