package particles.lab;

import java.util.LinkedHashMap;
import java.util.Map;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Vector3;

/** The forces on one particle, one for each effect and reaction that acts on it. */
final class ParticleForces {
    private ParticleForces() {
    }

    /** The present forces on particle i by the names of what causes them, three components each (N). */
    static Map<String, Object> of(ParticleSystem system, int i) {
        Map<String, Object> forces = new LinkedHashMap<>();
        double[] state = system.getOwnState();
        double[] sum = new double[system.getStateSize()];
        for (Effect effect : system.getEffects()) {
            put(forces, effect.getName(), () -> effect.addForces(state, system.getTime(), sum), sum, i);
        }
        for (Reaction reaction : system.getReactions()) {
            if (reaction.isActive()) {
                put(forces, reaction.getName(), () -> reaction.addForces(state, system.getTime(), sum), sum, i);
            }
        }
        return forces;
    }

    /** Puts what adds to the sum of forces, if it changes that on particle i. */
    private static void put(Map<String, Object> forces, String name, Runnable adding, double[] sum, int i) {
        Vector3 before = Vector3.at(sum, Particles.STRIDE * i + 3);
        adding.run();
        Vector3 force = Vector3.at(sum, Particles.STRIDE * i + 3).minus(before);
        if (!force.isZero()) {
            forces.put(name, SceneFacts.vector(force));
        }
    }
}
