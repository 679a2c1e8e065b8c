package particles.scene.parts;

import java.util.Collections;
import java.util.DoubleSummaryStatistics;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Estimates the kinetic energy to expect in a scene, before the run; many times more means that it blew up. The
 * estimate is the largest of
 * <ul>
 * <li>kinetic energy plus the energy that springs and other forces store at the start;</li>
 * <li>the energy that gravity can supply: the sum of m g (H + g T&sup2;/2), with H the extent of all particles along g
 *     and T the duration, since everything may fall for as long as the run lasts;</li>
 * <li>the energy that wind, emitters and moving anchors can supply: the sum of m w&sup2;/2, with w the largest of their
 * speeds, over all particles, including those born during the run;</li>
 * <li>the energy that uniform forces, and laws without a declared energy, as a student's own may be, can supply: the
 *     sum of F&sup2; T&sup2;/(2 m), with F the force at the start.</li>
 * </ul>
 * If all four are 0, or round-off, nothing in the scene causes motion. The estimate is then the kinetic energy with
 * which every particle would cross the scene once during the run, the sum of m (L/T)&sup2;/2 with L the scene's extent,
 * or 1 m if that is 0. Fixed particles do not count, except for H and L; if all are fixed it is 1 J.
 *
 * @param system   the system at its start
 * @param duration the duration of the run (s), over 0
 */
record EnergyEstimate(ParticleSystem system, double duration) {
    /** A smaller part of the energy of crossing the scene moves nothing by 1e-12 of the scene's extent: round-off. */
    private static final double ROUND_OFF = 1e-24;

    /**
     * @param g      the sum of the accelerations of uniform fields (m/s&sup2;)
     * @param speed  the largest speed of wind, emitters and moving anchors (m/s)
     * @param births the mass born per second (kg/s)
     * @return the estimate (J), over 0
     */
    double joules(Vector3 g, double speed, double births) {
        Particles particles = system.getParticles();
        double mass = particles.freeMass() + births * duration;
        if (mass == 0) {
            return 1;
        }
        double[] state = system.getOwnState();
        double[] ownForces = new double[state.length];
        double atStart = system.getKineticEnergy(state);
        for (Effect effect : system.getEffects()) {
            if (!Trait.isUniform(effect)) {
                atStart += Math.abs(effect.getPotentialEnergy(state, system.getTime()));
            }
            if (Trait.isUniform(effect) || Collections.disjoint(effect.getTraits(), Trait.OF_ENERGY)) {
                effect.addForces(state, system.getTime(), ownForces);
            }
        }
        double height = g.isZero() ? 0 : extent(g.normalized());
        double byGravity = mass * g.length() * (height + g.length() * duration * duration / 2);
        double byWind = mass * speed * speed / 2;
        double byOwnLaws = particles.sumOfFree(i -> {
            Vector3 f = Vector3.at(ownForces, Particles.STRIDE * i + 3);
            return f.dot(f) * duration * duration / 2 * particles.getInverseMasses()[i];
        });
        double scale = Math.max(Math.max(atStart, byOwnLaws), Math.max(byGravity, byWind));
        double crossing = crossing(mass);
        return scale > ROUND_OFF * crossing ? scale : crossing;
    }

    private double crossing(double mass) {
        double extent = Stream.of(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1))
                .mapToDouble(this::extent).max().orElseThrow();
        double speed = (extent > 0 ? extent : 1) / duration;
        return Math.max(Double.MIN_NORMAL, mass * speed * speed / 2);
    }

    private double extent(Vector3 direction) {
        DoubleSummaryStatistics along = system.getParticles().along(system.getOwnState(), direction);
        return along.getMax() - along.getMin();
    }
}
