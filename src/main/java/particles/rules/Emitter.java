package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.law.SeededRandom;
import particles.law.Vector3;

/**
 * A source of particles: the nozzle of a fountain, a fire's embers. Particle number n comes into being n/rate after the
 * run began, whatever the step; one that is due within a step is put where it would be at the step's end if nothing had
 * acted on it. Where and in which direction follows from the seed alone. Ids are the emitter's own with a number that
 * is never used again: {@code fountain[17]}.
 */
public final class Emitter implements Rule {
    private final Nozzle nozzle;
    private final SeededRandom random;
    private double startTime;
    private long born;

    /**
     * What an emitter is.
     *
     * @param id        its name, with which its particles' ids begin
     * @param position  where particles begin (m)
     * @param radius    how far from there at most, anywhere in a ball (m), 0 or more
     * @param direction where they go, the middle of the cone; of length 1
     * @param spread    the largest angle between a particle's direction and the middle (rad), 0 to pi
     * @param speed     how fast they go (m/s), 0 or more
     * @param rate      how many are born in a second (1/s), positive
     * @param mass      of each (kg), positive
     * @param lifetime  how long each lives (s), positive; may be infinite
     * @param seed      of the random numbers
     */
    public record Nozzle(String id, Vector3 position, double radius, Vector3 direction, double spread, double speed,
                         double rate, double mass, double lifetime, long seed) {
        /** @throws IllegalArgumentException if a number is out of its range or the direction has none */
        public Nozzle {
            direction = direction.normalized();
            if (!position.isFinite() || !(radius >= 0 && radius <= Double.MAX_VALUE)
                    || !(spread >= 0 && spread <= Math.PI)
                    || !(speed >= 0 && speed <= Double.MAX_VALUE) || !(rate > 0 && rate <= Double.MAX_VALUE)
                    || !(mass > 0 && mass <= Double.MAX_VALUE) || !(lifetime > 0)) {
                throw new IllegalArgumentException("emitter '" + id
                        + "' needs a finite position, radius and speed of 0 or"
                        + " more, a spread from 0 to pi, positive rate, mass and lifetime, not " + position + ", "
                        + radius
                        + ", " + speed + ", " + spread + ", " + rate + ", " + mass + ", " + lifetime);
            }
        }
    }

    /** @param nozzle what it is */
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
        for (double birth = nextBirth(); birth <= system.getTime(); birth = nextBirth()) {
            emit(system, birth);
            any = true;
        }
        return any;
    }

    private double nextBirth() {
        return startTime + (born + 1) / nozzle.rate();
    }

    private void emit(ParticleSystem system, double birth) {
        Vector3 velocity = random.nextDirection(nozzle.direction(), nozzle.spread()).times(nozzle.speed());
        Vector3 from = nozzle.position();
        if (nozzle.radius() > 0) {
            from = from.plus(random.nextDirection(nozzle.direction(), Math.PI)
                    .times(nozzle.radius() * StrictMath.cbrt(random.nextDouble())));
        }
        int i = system.addParticle(nozzle.id() + "[" + born + "]", nozzle.mass(),
                from.plus(velocity.times(system.getTime() - birth)), velocity, false);
        system.setLife(i, birth, birth + nozzle.lifetime());
        born++;
    }

    /** @return how many particles were born so far */
    public long getBorn() {
        return born;
    }
}
