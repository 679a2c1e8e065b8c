/**
 * Force laws: one law, one file. Each law reports the energy that it stores, dissipates or supplies. It also declares
 * its properties ({@link particles.law.Effect.Trait}). Tests check both. Its nested class {@code Keys} declares its
 * keys in a scene, and {@link particles.effects.EffectCatalog} lists all laws.
 *
 * <h2>A law of your own</h2>
 * {@code gradle newEffect -Pclass=MyForce} writes a class to start from, and {@code gradle checkEffect
 * -Peffect=exercises.MyForce} checks it. This is a complete law, {@code src/main/java/exercises/Coriolis.java}; a test
 * compiles and runs it:
 * <pre>{@code
 * package exercises;
 *
 * import java.util.Set;
 * import particles.law.ParticleForce;
 * import particles.law.Particles;
 * import particles.law.Vector3;
 * import particles.effects.EffectContext;
 * import particles.effects.EffectKind;
 * import particles.spec.Key;
 * import particles.spec.Values;
 * import particles.spec.VectorType;
 *
 * // The Coriolis force of a frame that turns with the angular velocity w: F = 2 m v x w. It does no work.
 * public final class Coriolis extends ParticleForce {
 *     private final Vector3 w;
 *
 *     public Coriolis(Particles particles, Vector3 w) {
 *         super(particles);
 *         this.w = w;
 *     }
 *
 *     @Override
 *     public Set<Trait> getTraits() {
 *         return Set.of(Trait.TRANSLATION_INVARIANT);
 *     }
 *
 *     @Override
 *     protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
 *         return velocity.cross(w).times(2 * mass);
 *     }
 *
 *     // In a scene: - exercises.Coriolis: {angularVelocity: [0, 1.57, 0]}
 *     public static final class Keys extends EffectKind {
 *         private static final Key<Vector3> ANGULAR_VELOCITY = VectorType.of("rad/s").required(
 *                 "angularVelocity", "How fast the frame turns, about which axis (rad/s).");
 *
 *         public Keys() {
 *             super("exercises.Coriolis", "The Coriolis force of a turning frame.", ANGULAR_VELOCITY);
 *         }
 *
 *         @Override
 *         public void build(Values values, EffectContext scene) {
 *             scene.add(new Coriolis(scene.particles(), values.get(ANGULAR_VELOCITY)));
 *         }
 *     }
 * }
 * }</pre>
 * A scene names the class:
 * <pre>{@code
 * title: A puck on a turntable
 * teaches: On a parabolic turntable gravity cancels the centrifugal force, and a puck circles twice per turn.
 * solver: rk4
 * deltaT: 0.01
 * duration: 2
 * particles:
 *   - {id: puck, position: [0, 0, 0], velocity: [1, 0, 0]}
 * effects:
 *   - exercises.Coriolis: {angularVelocity: [0, 1.5707963267948966, 0]}
 * }</pre>
 * If the force on a particle depends on other particles, as with springs, implement {@link particles.law.Effect}: one
 * call adds the forces on all particles.
 *
 * <h2>Adding a law to the program</h2>
 * Move the class into this package, give its {@code Keys} a short name, and add a line to {@link
 * particles.effects.EffectCatalog}. The test {@code SceneSchemaTest} then writes the new schema to {@code
 * build/scene.schema.json}: copy it over {@code scenes/scene.schema.json}. {@code gradle gallery} writes the reference
 * in {@code scenes/README.md} again.
 */
package particles.effects;
