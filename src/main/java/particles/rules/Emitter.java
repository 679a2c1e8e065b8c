package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.SimulationException;
import particles.law.CentralForce;
import particles.law.Effect;
import particles.law.Require;
import particles.law.SeededRandom;
import particles.law.Vector3;

/**
 * A source of particles, such as the nozzle of a fountain. The n-th particle is born n/rate after the beginning of the
 * run, for any deltaT: the loop ends a step there. Places and directions are random and depend on the seed only. Ids
 * are the emitter's id with a number from 0 on that is never reused: {@code fountain[17]} is the 18th.
 */
public final class Emitter implements Rule {
    /** Births within this fraction of a step after its end happen at the end. */
    private static final double ROUNDING = 1e-6;

    private final Nozzle nozzle;
    private final SeededRandom random;
    private double startTime;
    private long born;

    /**
     * The parameters of an emitter.
     *
     * @param id       the emitter's id, with which its particles' ids begin
     * @param jet      the places and velocities at birth
     * @param rate     births per second (1/s), positive
     * @param mass     the mass of each particle (kg), positive
     * @param lifetime the lifetime of each particle (s), positive; may be infinite
     * @param seed     the seed of the random numbers
     */
    public record Nozzle(String id, Jet jet, double rate, double mass, double lifetime, long seed) {
        /** @throws IllegalArgumentException if a number is out of its range */
        public Nozzle {
            Require.positive("the rate of emitter '" + id + "'", rate);
            Require.positive("the mass of its particles", mass);
            Require.positive("their lifetime", Math.min(Double.MAX_VALUE, lifetime));
        }
    }

    /**
     * The places and velocities of an emitter's particles at birth.
     *
     * @param position  the centre of the ball in which particles are born (m)
     * @param radius    the radius of that ball (m), 0 or more
     * @param direction the axis of the cone of initial directions; of length 1
     * @param spread    the half-angle of the cone (rad), 0 to pi
     * @param speed     the initial speed (m/s), 0 or more
     */
    public record Jet(Vector3 position, double radius, Vector3 direction, double spread, double speed) {
        /** @throws IllegalArgumentException if a number is out of its range or the direction has none */
        public Jet {
            direction = direction.normalized();
            position.requireFinite("the position of an emitter");
            Require.notNegative("its radius", radius);
            Require.notNegative("its speed", speed);
            if (!(spread >= 0 && spread <= Math.PI)) {
                throw new IllegalArgumentException("its spread has to be in 0 ... pi, not " + spread);
            }
        }
    }

    /** @param nozzle the parameters */
    public Emitter(Nozzle nozzle) {
        this.nozzle = nozzle;
        random = new SeededRandom(nozzle.seed());
    }

    @Override
    public String getName() {
        return "emitter";
    }

    @Override
    public void start(ParticleSystem system) {
        startTime = system.getTime();
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        boolean any = false;
        double now = system.getTime() + ROUNDING * deltaT;
        for (double birth = getNextTime(); birth <= now; birth = getNextTime()) {
            emit(system, birth);
            any = true;
        }
        return any;
    }

    @Override
    public double getNextTime() {
        return startTime + (born + 1) / nozzle.rate();
    }

    private void emit(ParticleSystem system, double birth) {
        Jet jet = nozzle.jet();
        Vector3 velocity = random.nextDirection(jet.direction(), jet.spread()).times(jet.speed());
        Vector3 from = jet.position();
        if (jet.radius() > 0) {
            from = from.plus(random.nextDirection(jet.direction(), Math.PI)
                    .times(jet.radius() * StrictMath.cbrt(random.nextDouble())));
        }
        int i = system.addParticle(nozzle.id() + "[" + born + "]", nozzle.mass(),
                from.plus(velocity.times(system.getTime() - birth)), velocity, false);
        system.setLife(i, birth, birth + nozzle.lifetime());
        born++;
        requireApart(system, i);
    }

    private static void requireApart(ParticleSystem system, int newborn) {
        for (Effect effect : system.getEffects()) {
            if (effect instanceof CentralForce central) {
                central.findAtOnePlace(system.getOwnState(), newborn).ifPresent(pair -> {
                    throw new SimulationException(system.getTime(), -1, "'" + system.getParticles().id(newborn)
                            + "' is born at the place of '" + system.getParticles().id(pair[0])
                            + "'; soft balls there have no direction in which to push each other", null);
                });
            }
        }
    }
}
