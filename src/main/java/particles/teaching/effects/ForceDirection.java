package particles.teaching.effects;

import java.util.Random;
import java.util.function.Function;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Particles;
import particles.teaching.Formula;

/**
 * Says what a force is on one particle, as measured. A sign that force and energy share breaks no claim; a reader who
 * knows what the law should do sees it here.
 */
public final class ForceDirection {
    private ForceDirection() {
    }

    /** @return a sentence with the force on the first particle of the sample, at rest and in motion */
    public static String of(Function<Particles, Effect> maker) {
        ParticleSystem system = EffectSample.system();
        EffectTrial trial = EffectTrial.random(system, maker.apply(system.getParticles()), new Random(17), 0);
        double[] moving = trial.state();
        return Formula.text(" Measured on %s at (%s, %s, %s) m: at rest the force is %s, and with v = (%s, %s, %s) m/s"
                + " it is %s.", trial.id(0), moving[0], moving[1], moving[2], force(trial, trial.faster(0)), moving[3],
                moving[4], moving[5], force(trial, moving));
    }

    private static String force(EffectTrial trial, double[] at) {
        double[] force = trial.force(at);
        return Formula.text("(%s, %s, %s) N", force[3], force[4], force[5]);
    }
}
