package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertMatches;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.app.cli.ExitCode;
import particles.effects.EffectContext;
import particles.effects.EffectKind;
import particles.law.Effect;
import particles.law.ParticleForce;
import particles.law.Particles;
import particles.law.Vector3;
import particles.spec.Values;

/** The check of a force law through the program: its screen, its report, and classes that do not come back. */
class CheckEffectCommandTest {

    /** The scene keys of a planted effect: none. */
    public abstract static class PlantedKeys extends EffectKind {
        private final Function<Particles, Effect> maker;

        PlantedKeys(Class<?> law, Function<Particles, Effect> maker) {
            super(law.getName(), "A law that goes wrong.");
            this.maker = maker;
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(maker.apply(scene.particles()));
        }
    }

    /** Ends everything. */
    public static class Exits extends ParticleForce {
        public Exits(Particles particles) {
            super(particles);
        }

        @Override
        protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
            System.exit(0);
            return Vector3.ZERO;
        }

        /** For the check. */
        public static final class Keys extends PlantedKeys {
            public Keys() {
                super(Exits.class, Exits::new);
            }
        }
    }

    /** Does not even begin. */
    public static final class ExitsAtOnce extends Exits {
        public ExitsAtOnce(Particles particles) {
            super(particles);
            Runtime.getRuntime().exit(0);
        }

        /** For the check. */
        public static final class Keys extends PlantedKeys {
            public Keys() {
                super(ExitsAtOnce.class, ExitsAtOnce::new);
            }
        }
    }

    private static String here(ExitCode expected, String effect, Path folder) {
        return Checks.here(expected, new Check(CheckEffectCommand.NAME, effect, ""), folder);
    }

    @Test
    void aRightLawHasNothingWrong(@TempDir Path folder) throws IOException {
        String screen = here(ExitCode.DONE, "damped-springs", folder);
        assertStarts(screen, "SpringForce: right. The effect 'springs' claims INTERNAL, ");
        assertTrue(screen.lines().count() <= 12, screen);
        assertStarts(Files.readString(folder.resolve("report/checkEffect.md")), "# SpringForce: The effect 'springs'");
    }

    @Test
    void anUnknownNameSaysWhatIsKnown(@TempDir Path folder) {
        assertHas(here(ExitCode.BAD_INPUT, "gravty", folder), """
                no effect is called 'gravty'; did you mean 'gravity'? known effects: attraction, cohesion, \
                damped-springs, drag, gravitation, gravity, magneticField, muscles, penaltyPlane, penaltySphere, push, \
                quadraticDrag, repulsion, springs, turbulence, vortex, wind""");
        assertHas(here(ExitCode.BAD_INPUT, "MyGravity", folder), """
                there is no class exercises.MyGravity with a 'public static final class Keys extends EffectKind' in \
                src/main/java/exercises; gradle newEffect writes one""");
    }

    @ParameterizedTest
    @ValueSource(classes = {Exits.class, ExitsAtOnce.class})
    void aClassThatEndsTheProgramIsFoundOut(Class<?> planted, @TempDir Path folder) throws Exception {
        String found = Checks.failureOf(new Check(CheckEffectCommand.NAME, planted.getName(), ""),
                planted, folder);
        assertMatches(found, "failure: the class ends the whole program .System.exit., in "
                + planted.getSimpleName() + "[.](getForce|<init>), line \\d+ of CheckEffectCommandTest.java");
    }
}
