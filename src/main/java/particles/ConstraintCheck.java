package particles;

import deSolvers.text.Digits;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Violation;

/**
 * Checks what constraints do, whatever the solver of their forces says: the lengths of rods, the distances of beads and
 * contacts, and the work of moving anchors, as reported and as the forces on the anchors do it. A run is checked at
 * about {@value #SAMPLES} steps, not more than one in {@value #STEPS}, and at its end; a rod to an anchor on a circle
 * may have its length again at the end.
 */
final class ConstraintCheck implements Observer {
    private static final int SAMPLES = 200;
    private static final int STEPS = 10;

    private final double longest;
    private final double interval;
    private double next = Double.NEGATIVE_INFINITY;
    private Violation worst = Violation.NONE;
    private double done;
    private double wrong;

    /**
     * @param longest  the longest step (s)
     * @param duration the duration of the run (s)
     */
    ConstraintCheck(double longest, double duration) {
        this.longest = longest;
        interval = Math.max(duration / SAMPLES, (STEPS - 1) * longest);
    }

    @Override
    public void started(ParticleSystem system) {
        next = system.getReactions().isEmpty() ? Double.POSITIVE_INFINITY : system.getTime();
    }

    @Override
    public double getNextTime() {
        return next;
    }

    /** {@inheritDoc} Looks at the motion's start, where rules have done their work. */
    @Override
    public void moved(Motion motion) {
        next = motion.getEndTime() + interval;
        look(motion.getSystem(), motion.getStartState(), motion.getStartTime());
        compareWork(motion.getSystem(), motion.getStartState(), motion.getStartTime());
    }

    private void look(ParticleSystem system, double[] state, double time) {
        for (Reaction reaction : system.getReactions()) {
            Violation violation = reaction.getViolation(state, time - longest);
            if (violation.part() > worst.part()) {
                worst = new Violation(violation.part(), violation.what() + " at t = " + Digits.few(time) + " s");
            }
        }
    }

    /** Adds up the power of moving anchors by the forces on them, and its difference from the reported one. */
    private void compareWork(ParticleSystem system, double[] state, double time) {
        if (system.getMovingAnchors().length == 0) {
            return;
        }
        double[] effects = new double[state.length];
        system.addUpEffects(state, time, effects);
        for (Reaction reaction : system.getReactions()) {
            double[] force = effects.clone();
            reaction.addForces(state, time, force);
            double power = 0;
            for (int anchor : system.getMovingAnchors()) {
                for (int v = Particles.STRIDE * anchor + 3; v < Particles.STRIDE * (anchor + 1); v++) {
                    power -= (force[v] - effects[v]) * state[v];
                }
            }
            done += Math.abs(power);
            // contacts have power too, that of friction, but no force on anchors
            wrong += power == 0 ? 0 : Math.abs(reaction.getPower(state, time, effects) - power);
        }
    }

    /** The largest violation that was seen. */
    Violation getWorst() {
        return worst;
    }

    /** The largest violation so far, with that of the present state. */
    Violation getWorst(ParticleSystem system) {
        look(system, system.getOwnState(), system.getTime());
        double part = done > 0 ? wrong / done : 0;
        return worst.or(new Violation(part, "the reported work of moving anchors is wrong by "
                + Digits.few(100 * part) + " %"));
    }
}
