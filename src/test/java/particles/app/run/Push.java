package particles.app.run;

import java.util.function.DoubleUnaryOperator;
import particles.effects.EffectContext;
import particles.effects.EffectKind;
import particles.law.ParticleForce;
import particles.law.Particles;
import particles.law.Vector3;
import particles.spec.Values;

/** A force of a student's own in x; it counts how often it is asked for. */
public final class Push extends ParticleForce {
    /** The force at a time (N). */
    static DoubleUnaryOperator strength;
    static long calls;

    /** @param particles the particles */
    public Push(Particles particles) {
        super(particles);
    }

    @Override
    protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
        calls++;
        return new Vector3(strength.applyAsDouble(time), 0, 0);
    }

    /** In a scene: - particles.app.run.Push */
    public static final class Keys extends EffectKind {
        /** For scenes. */
        public Keys() {
            super("particles.app.run.Push", "A force in x.");
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new Push(scene.particles()));
        }
    }
}
