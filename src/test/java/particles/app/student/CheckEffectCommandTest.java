package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.CheckProcess;
import particles.app.Main;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.run.StopRequest;
import particles.effects.EffectContext;
import particles.effects.EffectKind;
import particles.law.Effect;
import particles.law.Particles;
import particles.spec.Values;

/** The check of a force law through the program: its screen, its report, and classes that do not come back. */
class CheckEffectCommandTest {

    /** A law on every particle; what it does is left to those that go wrong. */
    public abstract static class Planted implements Effect {
        final Particles particles;

        Planted(Particles particles) {
            this.particles = particles;
        }

        @Override
        public String getName() {
            return "planted";
        }

        @Override
        public boolean dependsOnVelocity() {
            return false;
        }
    }

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
    public static final class Exits extends Planted {
        public Exits(Particles particles) {
            super(particles);
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            System.exit(0);
        }

        /** For the check. */
        public static final class Keys extends PlantedKeys {
            public Keys() {
                super(Exits.class, Exits::new);
            }
        }
    }

    /** Never ends: i stays what it is. */
    public static final class Loops extends Planted {
        public Loops(Particles particles) {
            super(particles);
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            int i = 0;
            while (i < particles.count()) {
                force[6 * i + 4] -= 9.81 * particles.mass(i);
            }
        }

        /** For the check. */
        public static final class Keys extends PlantedKeys {
            public Keys() {
                super(Loops.class, Loops::new);
            }
        }
    }

    /** Calls itself, in its energy. */
    public static final class Overflows extends Planted {
        public Overflows(Particles particles) {
            super(particles);
        }

        @Override
        public Set<Trait> getTraits() {
            return EnumSet.of(Trait.CONSERVATIVE);
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            for (int i = 0; i < particles.count(); i++) {
                force[6 * i + 4] -= 9.81 * particles.mass(i);
            }
        }

        @Override
        public double getPotentialEnergy(double[] state, double time) {
            return getPotentialEnergy(state, time) + 1;
        }

        /** For the check. */
        public static final class Keys extends PlantedKeys {
            public Keys() {
                super(Overflows.class, Overflows::new);
            }
        }
    }

    /** Asks for more than there is. */
    public static final class Hoards extends Planted {
        private final List<double[]> kept = new ArrayList<>();

        public Hoards(Particles particles) {
            super(particles);
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            while (kept.size() < 1_000_000) {
                kept.add(new double[10_000_000]);
            }
        }

        /** For the check. */
        public static final class Keys extends PlantedKeys {
            public Keys() {
                super(Hoards.class, Hoards::new);
            }
        }
    }

    /** Does not even begin. */
    public static final class ExitsAtOnce extends Planted {
        public ExitsAtOnce(Particles particles) {
            super(particles);
            Runtime.getRuntime().exit(0);
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            force[3] += 1;
        }

        /** For the check. */
        public static final class Keys extends PlantedKeys {
            public Keys() {
                super(ExitsAtOnce.class, ExitsAtOnce::new);
            }
        }
    }

    private static String here(ExitCode expected, String effect, Path folder) {
        StringWriter out = new StringWriter();
        PrintWriter both = new PrintWriter(out);
        ExitCode code = new Program(Main.commands(new StopRequest()), OptionStyle.SHELL, both, both)
                .execute("checkEffect", "--effect=" + effect, "--inThisProcess", "--out=" + folder.resolve("report"));
        assertEquals(expected, code, out.toString());
        return out.toString();
    }

    @Test
    void aRightLawHasNothingWrong(@TempDir Path folder) throws IOException {
        String screen = here(ExitCode.DONE, "damped-springs", folder);
        assertTrue(screen.startsWith("SpringForce: right. The effect 'springs' claims INTERNAL, "), screen);
        assertTrue(screen.lines().count() <= 12, screen);
        assertTrue(Files.readString(folder.resolve("report/checkEffect.md")).contains("Nothing is wrong."));
    }

    @Test
    void anUnknownNameSaysWhatIsKnown(@TempDir Path folder) {
        assertTrue(here(ExitCode.BAD_INPUT, "gravty", folder).contains("""
                no effect is called 'gravty'; did you mean 'gravity'? known effects: attraction, cohesion, \
                damped-springs, drag, gravity, penaltyPlane, penaltySphere, quadraticDrag, repulsion, \
                springs, turbulence, wind"""));
        assertTrue(here(ExitCode.BAD_INPUT, "MyGravity", folder).contains("""
                there is no class exercises.MyGravity; put your own class into src/main/java/exercises (gradle \
                newEffect writes one to start from)"""));
    }

    /** Java counts 247 MB of 256 MB as usable with its serial collector. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            Exits       | the class ends the whole program (System.exit), in Exits.addForces, line
            ExitsAtOnce | the class ends the whole program (System.exit), in ExitsAtOnce.<init>, line
            Overflows   | the stack overflows: a method calls itself without end, in Overflows.getPotentialEnergy, line
            Hoards      | it asks for more memory than the 247 MB that there are, in Hoards.addForces, line
            """)
    void aClassThatDoesNotComeBackIsFoundOut(String planted, String failure, @TempDir Path folder) throws Exception {
        String found = CheckProcess.failureOf("checkEffect", "--effect=",
                Class.forName(CheckEffectCommandTest.class.getName() + "$" + planted), folder);
        assertTrue(found.startsWith("failure: " + failure), found);
        assertTrue(found.endsWith(" of CheckEffectCommandTest.java"), "the place is named: " + found);
    }

    @Tag("slow")
    @Test
    void anEndlessLoopEndsTheCheckAndNotTheRun(@TempDir Path folder) throws Exception {
        aClassThatDoesNotComeBackIsFoundOut("Loops",
                "it did not come back within 7 s of CPU time: an endless loop, in Loops.addForces, line ", folder);
    }
}
