package particles.rules;

import java.util.Optional;
import java.util.function.Supplier;
import particles.ParticleSystem;
import particles.Rule;
import particles.SimulationException;
import particles.law.CentralForce;
import particles.law.Effect;
import particles.law.Require;
import particles.law.SeededRandom;
import particles.law.Vector3;
import particles.reactions.Tolerances;

/**
 * A source of particles, such as the nozzle of a fountain. The n-th particle is born n/rate after the beginning of the
 * run, for any deltaT: the loop ends a step there. A hard ball waits for room at its place, and is born at the end of a
 * step. Places and directions are random and depend on the seed only. Ids are the emitter's id with a number from 0 on
 * that is never reused: {@code fountain[17]} is the 18th.
 */
public final class Emitter implements Rule {
    private final Nozzle nozzle;
    private final Supplier<Optional<Collisions>> collisions;
    private final SeededRandom random;
    private double startTime;
    private long due;                                   // births so far, with those that wait
    private long born;
    private Vector3 place;                              // of the next birth
    private Vector3 velocity;

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

    /**
     * @param nozzle     the parameters
     * @param collisions gives the rule for hard balls, if particles are hard balls; it may be built later
     */
    public Emitter(Nozzle nozzle, Supplier<Optional<Collisions>> collisions) {
        this.nozzle = nozzle;
        this.collisions = collisions;
        random = new SeededRandom(nozzle.seed());
        aim();
    }

    @Override
    public long getWaiting() {
        return due - born;
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
        while (emit(system, system.getTime())) {        // those that have waited
            any = true;
        }
        double now = system.getTime() + Tolerances.BIRTH * deltaT;
        for (double birth = getNextTime(); birth <= now; birth = getNextTime()) {
            due++;
            any |= emit(system, getWaiting() == 1 ? birth : system.getTime());
        }
        return any;
    }

    /** Lets the first of those that are due be born, if there are any and there is room. */
    private boolean emit(ParticleSystem system, double birth) {
        Vector3 at = place.plus(velocity.times(system.getTime() - birth));
        Optional<Collisions> balls = collisions.get();
        if (getWaiting() == 0 || balls.isPresent() && !balls.get().hasRoom(at)) {
            return false;
        }
        int i = system.addParticle(nozzle.id() + "[" + born + "]", nozzle.mass(), at, velocity, false);
        system.setLife(i, birth, birth + nozzle.lifetime());
        balls.ifPresent(rule -> rule.addBall(i));
        born++;
        requireDirections(system, i);
        aim();
        return true;
    }

    @Override
    public double getNextTime() {
        return startTime + (due + 1) / nozzle.rate();
    }

    /** Draws the place and velocity of the next birth. */
    private void aim() {
        Jet jet = nozzle.jet();
        velocity = random.nextDirection(jet.direction(), jet.spread()).times(jet.speed());
        place = jet.position();
        if (jet.radius() > 0) {
            place = place.plus(random.nextDirection(jet.direction(), Math.PI)
                    .times(jet.radius() * StrictMath.cbrt(random.nextDouble())));
        }
    }

    private static void requireDirections(ParticleSystem system, int newborn) {
        for (Effect effect : system.getEffects()) {
            if (effect instanceof CentralForce central) {
                central.findUndirected(system.getOwnState(), newborn).ifPresent(where -> {
                    throw new SimulationException(system.getTime(), -1, where, null);
                });
            }
        }
    }
}
