package particles.lab;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Reaction;

/** The forces on one particle, one for each effect and reaction that acts on it. */
final class ParticleForces {
    private ParticleForces() {
    }

    /** The present forces on particle i by the names of what causes them, three components each (N). */
    static Map<String, Object> of(ParticleSystem system, int i) {
        Map<String, Object> forces = new LinkedHashMap<>();
        double[] state = system.getOwnState();
        double[] sum = new double[system.getStateSize()];
        double[] before = new double[3];
        for (Effect effect : system.getEffects()) {
            effect.addForces(state, system.getTime(), sum);
            put(forces, effect.getName(), sum, i, before);
        }
        for (Reaction reaction : system.getReactions()) {
            if (reaction.isActive()) {
                reaction.addForces(state, system.getTime(), sum);
                put(forces, reaction.getName(), sum, i, before);
            }
        }
        return forces;
    }

    private static void put(Map<String, Object> forces, String name, double[] sum, int i, double[] before) {
        List<Double> force = new ArrayList<>();
        boolean acts = false;
        for (int c = 0; c < 3; c++) {
            double total = sum[Particles.STRIDE * i + 3 + c];
            force.add(total - before[c]);
            acts |= total != before[c];
            before[c] = total;
        }
        if (acts) {
            forces.put(name, force);
        }
    }
}
