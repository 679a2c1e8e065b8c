package particles.energy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.Motion;
import particles.ParticleSystem;
import particles.Rule;
import particles.StridedRecorder;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Vector3;

/**
 * Energy balance of a run: kinetic and potential energy, and the work done on the system - continuously by drag,
 * damping, wind, friction and moving anchors, at once by bounces, births and deaths. A change of energy that no work
 * explains is numerical error: {@link #getNumericalError()} answers "is this loss physics or numerics?". Rods, wires
 * and surfaces at rest do no work, so any change of energy by their corrections counts as error.
 *
 * <p>Powers are integrated over each smooth piece of motion, and over each sub-step of an adaptive solver, by Simpson's
 * rule, from both ends and the middle of the cubic between them. The error is O(h<sup>4</sup>), so the numerical error
 * shows the order of any solver up to 4. A step may be too long for that: where an implicit solver jumps over a decay
 * or a fast vibration, the velocities at its ends say little about those in between. In such a step Simpson's rule is
 * far from the trapezoidal rule; the step then counts with the power at the mean velocity, the displacement divided by
 * the time. The ledger evaluates forces itself; these evaluations are not counted as the solver's and change nothing.
 */
public class EnergyLedger extends StridedRecorder {
    private static final int STRIDE = Particles.STRIDE;
    /**
     * Simpson's rule and the trapezoidal rule may differ by this part of the larger one. For the power of linear drag,
     * whose velocity decays as exp(-t/T), that is reached by a step of 2.0 T.
     */
    private static final double RESOLVED = 0.5;
    /**
     * Or by this part of the largest kinetic energy so far, or of the energy of motion and springs at the step's start:
     * where a motion turns round, little work is done, and the rules differ by much of it.
     */
    private static final double LITTLE = 0.01;

    private static final String ANCHORS = "moving anchors";

    /** One kind of work: its power and the sum so far. */
    private static final class Account {
        private final String force;                     // what does it
        private final String name;
        private final Power power;
        private final Power stored;                     // in the system's energy, though its change is this work (J)
        private final boolean changesBetweenSteps;
        private double powerBefore;
        private double work;

        Account(String force, String name, boolean changesBetweenSteps, Power power, Power stored) {
            this.force = force;
            this.name = name;
            this.changesBetweenSteps = changesBetweenSteps;
            this.power = power;
            this.stored = stored;
        }
    }

    /** The power that goes into the system (W). */
    private interface Power {
        double at(double[] state, double time);
    }

    private final List<Account> accounts = new ArrayList<>();
    private final Map<String, Double> jumps = new LinkedHashMap<>();
    private final Set<String> driving = new HashSet<>();
    private double[] middle = {};                       // the state in the middle of a step
    private double startEnergy;
    private double energy;
    private double largestKinetic;
    private double uncertainty;
    private boolean powersKnown;

    /** Keeps no curves; {@link EnergyLedgerRecorder} does. */
    public EnergyLedger() {
        this(1);
    }

    EnergyLedger(long stride) {
        super(stride);
    }

    @Override
    public void started(ParticleSystem system) {
        for (Effect effect : system.getEffects()) {
            if (effect.getTraits().contains(Trait.DISSIPATIVE)) {
                open(effect.getName(), effect.getName() + " (dissipated)", false,
                        (state, time) -> -effect.getDissipatedPower(state, time));
            }
            if (effect.getTraits().contains(Trait.DRIVING)) {
                driving.add(effect.getName() + " (driven)");
                open(effect.getName(), effect.getName() + " (driven)", false, effect::getDrivenPower);
            }
            if (Collections.disjoint(effect.getTraits(), Trait.OF_ENERGY)) {
                accounts.add(new Account(effect.getName(), effect.getName(), false,
                        (state, time) -> power(Stream.of(effect), system.getParticles().free(), state, time),
                        effect::getPotentialEnergy));
            }
        }
        for (Reaction reaction : system.getReactions()) {
            boolean isOfAnchors = reaction.transmitsWork() && system.getMovingAnchors().length > 0;
            String name = isOfAnchors ? ANCHORS : reaction.getName();
            open(name, name, true, (state, time) -> {
                if (!reaction.isActive()) {
                    return 0;
                }
                double[] force = new double[state.length];
                system.addUpEffects(state, time, force);
                return reaction.getPower(state, time, force);
            });
        }
        if (system.getMovingAnchors().length > 0) {
            driving.add(ANCHORS);
            // minus the internal forces on each anchor, times its velocity
            open(ANCHORS, ANCHORS, false, (state, time) -> -power(system.getEffects().stream()
                    .filter(effect -> effect.getTraits().contains(Trait.INTERNAL)),
                    Arrays.stream(system.getMovingAnchors()), state, time));
        }
        energy = system.getEnergy(system.getOwnState(), system.getTime());
        startEnergy = energy;
        super.started(system);
    }

    private void open(String force, String name, boolean changesBetweenSteps, Power power) {
        accounts.add(new Account(force, name, changesBetweenSteps, power, (state, time) -> 0));
    }

    @Override
    public void moved(Motion motion) {
        for (int k = 0; k < motion.getPieces(); k++) {
            book(motion.getPiece(k));
        }
        energy = motion.getSystem().getEnergy(motion.getEndState(), motion.getEndTime());
        super.moved(motion);
    }

    private void book(Motion motion) {
        ParticleSystem system = motion.getSystem();
        double t0 = motion.getStartTime();
        double t1 = motion.getEndTime();
        double half = t0 + (t1 - t0) / 2;
        if (!accounts.isEmpty()) {
            middle = middle.length == system.getStateSize() ? middle : new double[system.getStateSize()];
            motion.interpolate(half, middle);
        }
        largestKinetic = Math.max(largestKinetic, system.getKineticEnergy(motion.getStartState()));
        for (Account account : accounts) {
            double before = powersKnown && !account.changesBetweenSteps ? account.powerBefore
                    : account.power.at(motion.getStartState(), t0);
            double after = account.power.at(motion.getEndState(), t1);
            double trapezoid = (t1 - t0) / 2 * (before + after);
            double work = (trapezoid + 2 * (t1 - t0) * account.power.at(middle, half)) / 3;     // Simpson's
            double difference = Math.abs(work - trapezoid);
            if (difference > RESOLVED * Math.max(Math.abs(work), Math.abs(trapezoid))
                    && difference > LITTLE * Math.max(largestKinetic,
                            system.getInternalEnergy(motion.getStartState(), t0))) {
                work = (t1 - t0) * account.power.at(withMeanVelocities(middle, motion), half);
            }
            if (motion.isAdaptive() && difference > 0) {
                uncertainty += difference * Math.min(1, difference / Math.abs(trapezoid));
            }
            account.work += work + (account.stored.at(motion.getEndState(), t1)
                    - account.stored.at(motion.getStartState(), t0));
            account.powerBefore = after;
        }
        powersKnown = true;
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        double after = system.getEnergy(system.getOwnState(), system.getTime());
        if (!rule.isCorrection()) {
            jumps.merge(rule.getName(), after - energy, (before, more) -> before + more);
        }
        energy = after;
        powersKnown = false;
        super.changed(system, rule);
    }

    /** The positions in the middle, with the mean velocities of the motion: displacement divided by time. */
    private static double[] withMeanVelocities(double[] middle, Motion motion) {
        double time = motion.getEndTime() - motion.getStartTime();
        double[] mean = middle.clone();
        for (int x = 0; x < mean.length; x += STRIDE) {
            Vector3.at(motion.getEndState(), x).minus(Vector3.at(motion.getStartState(), x)).over(time)
                    .put(mean, x + 3);
        }
        return mean;
    }

    /** The power of effects' forces on some particles (W). */
    private static double power(Stream<Effect> effects, IntStream particles, double[] state, double time) {
        double[] force = new double[state.length];
        effects.forEach(effect -> effect.addForces(state, time, force));
        double power = 0;
        for (int i : particles.toArray()) {
            power += Vector3.at(force, STRIDE * i + 3).dot(Vector3.at(state, STRIDE * i + 3));
        }
        return power;
    }

    /** @return the total energy at the beginning (J) */
    public double getStartEnergy() {
        return startEnergy;
    }

    /** @return the total energy now (J) */
    public double getEnergy() {
        return energy;
    }

    /**
     * The work done on the system so far.
     *
     * @return the work (J) by name; negative if energy was taken out
     */
    public Map<String, Double> getWork() {
        return sums(account -> account.name);
    }

    /**
     * The work done on the system so far by each effect, reaction and rule, and by moving anchors: what it dissipated
     * and what it drove together. What an effect took from its potential energy is not work on the system.
     *
     * @return the work (J) by the name of what did it; negative if energy was taken out
     */
    public Map<String, Double> getWorkByForce() {
        return sums(account -> account.force);
    }

    private Map<String, Double> sums(Function<Account, String> name) {
        Map<String, Double> work = new LinkedHashMap<>();
        for (Account account : accounts) {
            work.merge(name.apply(account), account.work, (before, more) -> before + more);
        }
        jumps.forEach((rule, joules) -> work.merge(rule, joules, (before, more) -> before + more));
        return work;
    }

    /** @return whether this kind of work drives the system */
    boolean isDriving(String work) {
        return driving.contains(work);
    }

    /**
     * Estimates the error of the ledger's own integrals, for adaptive solvers: some of their sub-steps are too long for
     * Simpson's rule. A sub-step contributes d min(1, d/|w|), where w is the work by the trapezoidal rule and d the
     * difference of the two rules: almost nothing where they agree, and all of d where they do not.
     *
     * @return the uncertainty of the numerical error (J); 0 for other solvers
     */
    public double getUncertainty() {
        return uncertainty;
    }

    /** @return the numerical error (J): the total energy now, minus that at the beginning, minus all work */
    public double getNumericalError() {
        return energy - startEnergy - getWork().values().stream().reduce(0.0, (sum, work) -> sum + work);
    }
}
