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
import particles.Sphere;
import particles.Vector3;
import particles.effects.Cohesion;
import particles.effects.Gravity;
import particles.effects.GustyWind;
import particles.effects.LinearDrag;
import particles.effects.PenaltyPlane;
import particles.effects.PenaltySphere;
import particles.effects.PointAttraction;
import particles.effects.QuadraticDrag;
import particles.effects.SpringForce;
import particles.effects.TurbulentWind;
import particles.effects.Wind;

/** A handful of particles for an effect to act on, and effects by name. */
public final class EffectSample {
    /** By the names that scenes have for them, and springs, which scenes have elsewhere. */
    private static final Map<String, Function<Particles, Effect>> NAMED = Map.ofEntries(
            Map.entry("gravity", p -> new Gravity(p, new Vector3(0, -9.81, 0))),
            Map.entry("wind", p -> new LinearDrag(p, 0.4, new GustyWind(new Vector3(2, 0, 1), new Vector3(1, 0.5, 0), 1.7))),
            Map.entry("turbulence", p -> new QuadraticDrag(p, 0.4, new TurbulentWind(Vector3.ZERO, 1.5, 2, 42))),
            Map.entry("drag", p -> new LinearDrag(p, 0.4, Wind.STILL)),
            Map.entry("quadraticDrag", p -> new QuadraticDrag(p, 0.4, Wind.STILL)),
            Map.entry("attraction", p -> new PointAttraction(p, new Vector3(0.5, -2, 0.4), 3, 0.1)),
            Map.entry("cohesion", p -> new Cohesion(p, 1.9, 1.1, 2, 0.5)),
            Map.entry("penaltyPlane",
                    p -> new PenaltyPlane(p, new Plane(new Vector3(1, 0.5, 1), new Vector3(1, 2, -1)), 30, 0.8)),
            Map.entry("penaltySphere", p -> new PenaltySphere(p, new Sphere(new Vector3(1, 0.3, 0.8), 1.2, false), 30, 0.8)),
            Map.entry("springs", p -> springs(p, 0)), Map.entry("damped-springs", p -> springs(p, 0.8)));

    /** As they were called before. */
    private static final Map<String, String> ALSO = Map.of("linear-drag", "drag", "quadratic-drag", "quadraticDrag",
            "penalty-plane", "penaltyPlane");

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
     * @param name      of ours the one that scenes have; wind and turbulence are drag in them; or a class of one's own with
     *                  a public constructor that takes {@link Particles}
     * @param particles on whom it acts
     * @return the effect
     * @throws NoSuchElementException   if there is neither
     * @throws IllegalArgumentException if the class is no effect or cannot be made
     */
    public static Effect create(String name, Particles particles) {
        String scenesName = ALSO.getOrDefault(name, name);
        if (NAMED.containsKey(scenesName)) {
            return NAMED.get(scenesName).apply(particles);
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
        } catch (LinkageError e) {                      // a static field fails; at the second time there is no cause
            throw new IllegalArgumentException("class " + full + " cannot be loaded: "
                    + (e.getCause() == null ? e : e.getCause()), e);
        } catch (NoSuchMethodException | InstantiationException | IllegalAccessException e) {
            throw new IllegalArgumentException("class " + full
                    + " cannot be made: it has to be public, not abstract, and have a public"
                    + " constructor that takes particles.Particles", e);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException("the constructor of " + full + " failed: " + e.getCause(), e);
        }
    }
}
