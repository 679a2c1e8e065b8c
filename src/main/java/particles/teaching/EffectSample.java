package particles.teaching;

import java.lang.reflect.InvocationTargetException;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Random;
import java.util.TreeSet;
import java.util.function.Function;
import particles.Effect;
import particles.ParticleSystem;
import particles.Particles;
import particles.Plane;
import particles.Vector3;
import particles.effects.Cohesion;
import particles.effects.Gravity;
import particles.effects.LinearDrag;
import particles.effects.PenaltyPlane;
import particles.effects.PointAttraction;
import particles.effects.QuadraticDrag;
import particles.effects.SpringForce;
import particles.effects.Wind;

/** A handful of particles for an effect to act on, and effects by name. */
public final class EffectSample {
    private static final Map<String, Function<Particles, Effect>> NAMED = Map.of(
            "gravity", p -> new Gravity(p, new Vector3(0, -9.81, 0)),
            "springs", p -> springs(p, 0), "damped-springs", p -> springs(p, 0.8),
            "linear-drag", p -> new LinearDrag(p, 0.4, Wind.STILL), "quadratic-drag", p -> new QuadraticDrag(p, 0.4, Wind.STILL),
            "attraction", p -> new PointAttraction(p, new Vector3(0.5, -2, 0.4), 3, 0.1),
            "cohesion", p -> new Cohesion(p, 1.9, 1.1, 2, 0.5),
            "penalty-plane", p -> new PenaltyPlane(p, new Plane(new Vector3(1, 0.5, 1), new Vector3(1, 2, -1)), 30, 0.8));

    private EffectSample() {
    }

    /** @return six particles p0 to p5 about a unit apart, of different masses; p4 is fixed */
    public static ParticleSystem system() {
        ParticleSystem system = new ParticleSystem();
        Random random = new Random(715);
        for (int i = 0; i < 6; i++) {
            system.addParticle("p" + i, 0.5 + random.nextDouble(), new Vector3(i % 3, i / 3, 0.5 * i), Vector3.ZERO, i == 4);
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
     * Makes an effect.
     *
     * @param name      one of ours, or a class of one's own with a public constructor that takes {@link Particles}
     * @param particles on whom it acts
     * @return the effect
     * @throws NoSuchElementException   if there is neither
     * @throws IllegalArgumentException if the class is no effect or cannot be made
     */
    public static Effect create(String name, Particles particles) {
        if (NAMED.containsKey(name)) {
            return NAMED.get(name).apply(particles);
        }
        String full = name.contains(".") ? name : "exercises." + name;
        try {
            Class<?> found = Class.forName(full, true, Thread.currentThread().getContextClassLoader());
            if (!Effect.class.isAssignableFrom(found)) {
                throw new IllegalArgumentException("class " + full + " is no effect: it has to implement "
                        + Effect.class.getName());
            }
            return found.asSubclass(Effect.class).getConstructor(Particles.class).newInstance(particles);
        } catch (ClassNotFoundException e) {
            throw new NoSuchElementException("no class is called '" + full + "', and no effect; known effects: "
                    + String.join(", ", new TreeSet<>(NAMED.keySet())), e);
        } catch (NoSuchMethodException | InstantiationException | IllegalAccessException e) {
            throw new IllegalArgumentException("class " + full
                    + " cannot be made: it has to be public, not abstract, and have a public"
                    + " constructor that takes particles.Particles", e);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException("the constructor of " + full + " failed: " + e.getCause(), e);
        }
    }
}
