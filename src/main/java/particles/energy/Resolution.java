package particles.energy;

import java.util.Arrays;
import java.util.Optional;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.law.BriefForce;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Tells whether the steps of a run resolve its fastest visible vibration, which takes {@value #STEPS} steps per period.
 * Two measures are taken, and the shorter period counts.
 *
 * <p>The first is of the motion as computed: w is a particle's displacement in a step divided by the step, and S0, S1
 * and S2 are the sums of m |w|&sup2;, of its first differences and of its second differences from step to step. A
 * vibration whose phase advances by theta per step has S1 / S0 = S2 / S1 = q, with q = (2 sin(theta/2))&sup2;, and 1 at
 * six steps per period. So S2 / S1 is the mean of q over all that changes velocities. What has S1 / S0 below
 * {@value #VISIBLE} has less than a twentieth of the kinetic energy, and cannot be seen.
 *
 * <p>The second is of the forces, since a solver may make a vibration slower than it is, and one step has no second
 * difference: -dF . d / (m |d|&sup2;), with the displacement d in a step and the change dF of the force from its start
 * to its end, is the mean of omega&sup2; over all modes, each by its part of the kinetic energy. It is taken from about
 * {@value #SAMPLES} steps of a run.
 *
 * <p>A stiff spring that is damped out, or was never excited, moves no particle and does not count. Neither do bounces,
 * births and other jumps: a particle counts while its path is unbroken and its steps are as long as deltaT.
 *
 * <p>Apart from vibrations, a step may skip a force that comes and goes within it ({@link BriefForce}), or the motion
 * of an anchor.
 */
public final class Resolution implements Observer {
    /** A period needs so many steps. */
    static final int STEPS = 6;
    /** The least S1 / S0. */
    static final double VISIBLE = 0.05;
    /** Kinetic energies below this part of the energy scale are the rounding of a scene at rest. */
    private static final double AT_REST = 1e-9;
    /** The number of steps, spread over the run, in which forces are compared. */
    private static final int SAMPLES = 100;
    /** Steps that differ by less are equally long. */
    private static final double ROUNDING = 1e-6;

    private final double deltaT;
    private final long stride;
    private double[] end = {};                          // the state at the end of the last step
    private double[] velocity = {};                     // w of the last step, in the entries of v
    private double[] change = {};                       // its difference from the one before
    private int[] unbroken = {};                        // how many of the last steps a particle's path is unbroken
    private final double[] sums = new double[3];
    private double pull;                                // the sum of -dF . d
    private double inertia;                             // and of m |d|^2 / deltaT^2
    private long steps;
    private Optional<Brief> shortest = Optional.empty();

    /**
     * A force or an anchor's motion that is too fast for the steps.
     *
     * @param name what it is
     * @param time the shortest time in which it may come and go (s)
     */
    public record Brief(String name, double time) {
        /** @return the longest step that does not skip it (s) */
        public double longestStep() {
            return ParticleSystem.PART * time;
        }
    }

    /**
     * @param deltaT   the time step of the run (s)
     * @param duration its duration (s)
     */
    public Resolution(double deltaT, double duration) {
        this.deltaT = Math.min(deltaT, duration);
        stride = Math.max(1, (long) (duration / deltaT / SAMPLES));
    }

    @Override
    public void moved(Motion motion) {
        Particles particles = motion.getSystem().getParticles();
        double[] from = motion.getStartState();
        double[] to = motion.getEndState();
        double h = motion.getEndTime() - motion.getStartTime();
        if (!motion.isAdaptive()) {                     // those keep their sub-steps shorter
            findBrief(motion.getSystem(), from, motion.getStartTime(), h);
            findBrief(motion.getSystem(), to, motion.getEndTime(), h);
        }
        if (unbroken.length != particles.count()) {
            end = new double[to.length];
            velocity = new double[to.length];
            change = new double[to.length];
            unbroken = new int[particles.count()];
        }
        if (Math.abs(h - deltaT) > ROUNDING * deltaT) {
            Arrays.fill(unbroken, 0);
            return;
        }
        if (steps++ % stride == 0) {
            addForces(motion, h);
        }
        for (int i = 0; i < unbroken.length; i++) {
            if (!particles.isFixed(i)) {
                int x = Particles.STRIDE * i;
                boolean goesOn = Arrays.equals(from, x, x + Particles.STRIDE, end, x, x + Particles.STRIDE);
                unbroken[i] = goesOn ? unbroken[i] : 0;
                add(particles.mass(i), from, to, x, h, unbroken[i]++);
            }
        }
        System.arraycopy(to, 0, end, 0, to.length);
    }

    /** Notes what may come and go within a step, if it is faster than anything before. */
    private void findBrief(ParticleSystem system, double[] state, double time, double h) {
        double most = Math.min(h / ParticleSystem.PART / (1 + ROUNDING),
                shortest.map(Brief::time).orElse(Double.POSITIVE_INFINITY));
        double found = system.getShortestTime(state, time);
        if (found < most) {
            String name = system.getEffects().stream().filter(effect -> effect instanceof BriefForce brief
                    && brief.getShortestTime(state, time) == found).map(Effect::getName).findFirst()
                    .orElse("the motion of an anchor");
            shortest = Optional.of(new Brief(name, found));
        }
    }

    /** @return what may come and go in less time than four steps take, if anything may */
    public Optional<Brief> getBrief() {
        return shortest;
    }

    /** Adds what forces change along the displacement; velocities and time are those before the step. */
    private void addForces(Motion motion, double h) {
        ParticleSystem system = motion.getSystem();
        double[] before = motion.getStartState().clone();
        double[] moved = before.clone();
        double[] first = new double[before.length];
        double[] second = new double[before.length];
        for (int x = 0; x < moved.length; x += Particles.STRIDE) {
            System.arraycopy(motion.getEndState(), x, moved, x, 3);
        }
        system.addUpEffects(before, motion.getStartTime(), first);
        system.addUpEffects(moved, motion.getStartTime(), second);
        for (int i = 0; i < unbroken.length; i++) {
            if (!system.getParticles().isFixed(i)) {
                int x = Particles.STRIDE * i;
                Vector3 displacement = Vector3.at(moved, x).minus(Vector3.at(before, x));
                pull -= Vector3.at(second, x + 3).minus(Vector3.at(first, x + 3)).dot(displacement);
                inertia += system.getParticles().mass(i) * displacement.dot(displacement) / (h * h);
            }
        }
    }

    private void add(double mass, double[] from, double[] to, int x, double h, int known) {
        for (int c = x; c < x + 3; c++) {
            double w = (to[c] - from[c]) / h;
            double first = w - velocity[c];
            double second = first - change[c];
            if (known >= 2) {
                sums[0] += mass * w * w;
                sums[1] += mass * first * first;
                sums[2] += mass * second * second;
            }
            velocity[c] = w;
            change[c] = first;
        }
    }

    /**
     * @param energyScale the energy scale of the run (J)
     * @return the steps per period of the fastest visible vibration; infinite if there is none
     */
    public double stepsPerPeriod(double energyScale) {
        double rest = AT_REST * energyScale;
        double byForces = inertia > rest * steps / stride && pull > 0 ? 2 * Math.PI / Math.sqrt(pull / inertia)
                : Double.POSITIVE_INFINITY;
        boolean visible = sums[0] > rest * steps && sums[1] >= VISIBLE * sums[0];
        return Math.min(byForces, visible ? Math.PI / Math.asin(Math.min(1, Math.sqrt(sums[2] / sums[1]) / 2))
                : Double.POSITIVE_INFINITY);
    }

    /**
     * @param energyScale the energy scale of the run (J)
     * @return whether a visible vibration has too few steps per period
     */
    public boolean isTooCoarse(double energyScale) {
        return stepsPerPeriod(energyScale) < STEPS;
    }
}
