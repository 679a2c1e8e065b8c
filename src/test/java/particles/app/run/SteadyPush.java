package particles.app.run;

import particles.effects.EffectContext;
import particles.effects.EffectKind;
import particles.law.ParticleForce;
import particles.law.Particles;
import particles.law.Vector3;
import particles.spec.Values;

/** A force of a student's own, 1 N in x; it counts how often it is asked for. */
public final class SteadyPush extends ParticleForce {
    static long calls;

    /** @param particles the particles */
    public SteadyPush(Particles particles) {
        super(particles);
    }

    @Override
    protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
        calls++;
        return new Vector3(1, 0, 0);
    }

    /** In a scene: - particles.app.run.SteadyPush */
    public static final class Keys extends EffectKind {
        /** For scenes. */
        public Keys() {
            super("particles.app.run.SteadyPush", "A force of 1 N in x.");
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new SteadyPush(scene.particles()));
        }
    }
}
