package benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Particles;
import particles.scene.format.SceneFormat;

/** Every effect that a scene can name has a case in which it acts. */
class EffectCasesTest {

    static List<String> names() {
        return EffectCases.names();
    }

    @Test
    void theCasesAreTheEffectsOfTheSceneFormatAndTheSprings() {
        Matcher list = Pattern.compile("(?m)^\\| `effects` \\| a list of: ([^|]*) \\|")
                .matcher(SceneFormat.reference("###"));
        assertTrue(list.find());
        Set<String> all = new TreeSet<>(Set.of(list.group(1).replaceFirst(", or the full name.*", "").replace("`",
                "").split(", ")));
        all.add("springs");
        assertEquals(all, new TreeSet<>(names()));
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyParticleFeelsIt(String name) {
        ParticleSystem system = EffectCases.build(name);
        Effect effect = EffectCases.effect(name, system);
        assertEquals(switch (name) {
            case "wind", "turbulence" -> "drag";
            default -> name;
        }, effect.getName());
        double[] state = system.getStateArray();
        double[] force = new double[state.length];
        effect.addForces(state, 0.25, force);
        for (int v = 3; v < force.length; v += Particles.STRIDE) {
            assertTrue(force[v] != 0 || force[v + 1] != 0 || force[v + 2] != 0, name + ", entry " + v);
        }
    }
}
