package particles.teaching.effects;

/** The template of a student's force law: it compiles, and its keys can be used in a scene. */
public final class EffectSkeleton {

    private EffectSkeleton() {
    }

    /**
     * @param name the class's name
     * @return the text of a force law
     */
    public static String effect(String name) {
        return """
                package exercises;

                import particles.effects.EffectContext;
                import particles.effects.EffectKind;
                import particles.law.ParticleForce;
                import particles.law.Particles;
                import particles.law.Vector3;
                import particles.spec.Key;
                import particles.spec.NumberType;
                import particles.spec.Values;

                /** My own force law. To see what is wrong with it: gradle checkEffect -Peffect=exercises.NAME */
                public class NAME extends ParticleForce {
                    private final double strength;

                    public NAME(Particles particles, double strength) {
                        super(particles);
                        this.strength = strength;
                    }

                    @Override
                    protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                        // the total force on the particle, in newton, such as: return velocity.times(-strength);
                        return Vector3.ZERO;
                    }

                    // A conservative force also overrides getPotentialEnergy, and claims CONSERVATIVE in getTraits;
                    // one that damps overrides getDissipatedPower.

                    /** In a scene: - exercises.NAME: {strength: 2} */
                    public static final class Keys extends EffectKind {
                        private static final Key<Double> STRENGTH = Key.required("strength", NumberType.any("N s/m"),
                                "The force for each m/s of velocity (N s/m).");

                        public Keys() {
                            super("exercises.NAME", "My own force.", STRENGTH);
                        }

                        @Override
                        public void build(Values values, EffectContext scene) {
                            scene.add(new NAME(scene.particles(), values.get(STRENGTH)));
                        }
                    }
                }
                """.replace("NAME", name);
    }
}
