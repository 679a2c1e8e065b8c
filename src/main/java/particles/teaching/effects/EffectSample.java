package particles.teaching.effects;

import deSolvers.text.DidYouMean;
import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.Random;
import java.util.TreeSet;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.effects.EffectCatalog;
import particles.effects.EffectContext;
import particles.effects.EffectKind;
import particles.effects.Wind;
import particles.effects.springs.SpringForce;
import particles.law.Effect;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;
import particles.spec.ClassNames;

/** Sample systems on which effects are checked, and effects by name. */
public final class EffectSample {
    private static final String SPRINGS = "springs";
    private static final String DAMPED_SPRINGS = "damped-springs";

    private EffectSample() {
    }

    /** @return six particles p0 to p5 about a unit apart, of different masses; p4 is fixed */
    public static ParticleSystem system() {
        return system(6, 4);
    }

    /** @return nine such particles, all free */
    static ParticleSystem larger() {
        return system(9, -1);
    }

    private static ParticleSystem system(int count, int fixed) {
        ParticleSystem system = new ParticleSystem();
        Random random = new Random(715);
        for (int i = 0; i < count; i++) {
            system.addParticle("p" + i, 0.5 + random.nextDouble(), new Vector3(i % 3, i / 3, 0.5 * i), Vector3.ZERO,
                    i == fixed);
        }
        return system;
    }

    private static SpringForce springs(Particles particles, double damping) {
        SpringForce springs = new SpringForce(particles);
        for (int i = 1; i < particles.count(); i++) {
            springs.addSpring(i - 1, i, 10 + i, 0.8, damping);
        }
        return springs;
    }

    /**
     * Creates an effect as a scene would, from the defaults of its keys and samples of required ones.
     *
     * @param name      the effect's name in scenes; wind and turbulence are checked through drag; or springs,
     *                  damped-springs, or a class of one's own
     * @param particles the particles
     * @param classes   finds the class
     * @return the effect
     * @throws NoSuchElementException   if there is no such effect
     * @throws IllegalArgumentException if there is no such class, or it cannot be made
     */
    public static Effect create(String name, Particles particles, ClassNames classes) {
        if (name.equals(SPRINGS) || name.equals(DAMPED_SPRINGS)) {
            return springs(particles, name.equals(SPRINGS) ? 0 : 0.8);
        }
        EffectKind kind = named(name).orElseGet(() -> byClass(name, classes));
        Sample scene = new Sample(particles);
        kind.build(kind.samples(), scene);
        if (scene.effects.isEmpty()) {                  // wind has no force of its own
            checkedThrough(name).flatMap(EffectSample::named)
                    .ifPresent(other -> other.build(other.samples(), scene));
        }
        if (scene.effects.isEmpty()) {
            throw new IllegalArgumentException("the Keys of " + name + " add no effect to the scene");
        }
        return scene.effects.get(0);
    }

    /**
     * @param name the name of an effect
     * @return the effect through which an effect without a force of its own is checked, as wind through drag
     */
    private static Optional<String> checkedThrough(String name) {
        return named(name).flatMap(kind -> kind.needs().stream().findFirst());
    }

    private static Optional<EffectKind> named(String name) {
        return EffectCatalog.ALL.stream().filter(kind -> kind.getName().equals(name)).findFirst();
    }

    private static EffectKind byClass(String name, ClassNames classes) {
        if (Character.isLowerCase(name.charAt(0)) && !name.contains(".")) {
            TreeSet<String> known = new TreeSet<>(List.of(SPRINGS, DAMPED_SPRINGS));
            EffectCatalog.ALL.forEach(kind -> known.add(kind.getName()));
            throw new NoSuchElementException("no effect is called '" + name + "'"
                    + DidYouMean.hint(name, known, "'%s'"::formatted) + " known effects: "
                    + String.join(", ", known));
        }
        return classes.find(name.contains(".") ? name : "exercises." + name, EffectKind.class);
    }

    /** A scene of which only the effects matter. */
    private static final class Sample implements EffectContext {
        private final Particles particles;
        private final List<Effect> effects = new ArrayList<>();
        private final SpringForce springs;
        private Wind wind = Wind.STILL;

        Sample(Particles particles) {
            this.particles = particles;
            springs = EffectSample.springs(particles, 0);
        }

        @Override
        public Particles particles() {
            return particles;
        }

        /** The particles stand in a row along x, 1 m apart. */
        @Override
        public Vector3 position(int particle) {
            return new Vector3(particle, 0, 0);
        }

        @Override
        public SpringForce springs() {
            return springs;
        }

        @Override
        public IntStream springs(String shape, String family, Optional<String> part) {
            return IntStream.empty();
        }

        @Override
        public Wind wind() {
            return wind;
        }

        @Override
        public void add(Effect effect) {
            effects.add(effect);
        }

        @Override
        public void setWind(Wind wind) {
            this.wind = wind;
        }

        @Override
        public void show(Obstacle solid) {              // nothing is drawn
        }
    }
}
