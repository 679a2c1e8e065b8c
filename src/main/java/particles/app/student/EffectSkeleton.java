package particles.app.student;

/** The template of a student's force law: it compiles, and its keys can be used in a scene. */
public final class EffectSkeleton {
    /** What a conservative law has, and what stands there in others. */
    private static final String ENERGY = """

                @Override
                public Set<Trait> getTraits() {
                    return EnumSet.of(Trait.CONSERVATIVE);
                }

                @Override
                public boolean dependsOnVelocity() {
                    return false;
                }

                @Override
                protected double getPotentialEnergy(Vector3 position, double mass, double time) {
                    // its potential energy, in joule, such as: return 0.5 * strength * position.dot(position);
                    return 0;
                }
            """;
    private static final String NO_ENERGY = """

                // With -Pconservative=true, newEffect writes a law with a potential energy. A law that claims
                // nothing is right too; a run then lists its work, whether that is stored or lost.
            """;

    private EffectSkeleton() {
    }

    /**
     * @param name         the class's name
     * @param conservative whether it has a potential energy
     * @return the text of a force law
     */
    public static String effect(String name, boolean conservative) {
        String text = """
                package exercises;

                IMPORTS
                /** My own force law. To see what is wrong with it: gradle checkEffect -Peffect=exercises.NAME */
                public class NAME extends ParticleForce {
                    private final double strength;

                    public NAME(Particles particles, double strength) {
                        super(particles);
                        this.strength = strength;
                    }

                    @Override
                    protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                        // the total force on the particle, in newton, such as: return VARIABLE.times(-strength);
                        return Vector3.ZERO;
                    }
                ENERGY
                    /** In a scene: - exercises.NAME: {strength: 2} */
                    public static final class Keys extends EffectKind {
                        private static final Key<Double> STRENGTH = NumberType.any("UNIT").required("strength",
                                "The force for each UNIT_OF_VARIABLE of VARIABLE (UNIT).");

                        public Keys() {
                            super("exercises.NAME", "My own force.", STRENGTH);
                        }

                        @Override
                        public void build(Values values, EffectContext scene) {
                            scene.add(new NAME(scene.particles(), values.get(STRENGTH)));
                        }
                    }
                }
                """;
        String imports = """
                import particles.effects.EffectContext;
                import particles.effects.EffectKind;
                import particles.law.ParticleForce;
                import particles.law.Particles;
                import particles.law.Vector3;
                import particles.spec.Key;
                import particles.spec.NumberType;
                import particles.spec.Values;
                """;
        return text.replace("IMPORTS\n", (conservative ? "import java.util.EnumSet;\nimport java.util.Set;\n" : "")
                + imports + "\n").replace("ENERGY\n", (conservative ? ENERGY : NO_ENERGY) + "\n")
                .replace("UNIT_OF_VARIABLE", conservative ? "m" : "m/s").replace("UNIT", conservative ? "N/m" : "N s/m")
                .replace("VARIABLE", conservative ? "position" : "velocity").replace("NAME", name);
    }
}
