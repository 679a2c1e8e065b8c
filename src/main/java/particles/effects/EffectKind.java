package particles.effects;

import java.util.List;
import java.util.Optional;
import particles.spec.Key;
import particles.spec.Kind;
import particles.spec.Values;

/**
 * An effect's entry in scene files: its name, its keys, and how it is built from their values. Each effect declares it
 * in a nested class {@code Keys} with a public constructor without parameters.
 */
public abstract class EffectKind extends Kind {
    /**
     * @param name     the name in scenes; for a law that is not in {@link EffectCatalog} the full name of its class
     * @param sentence a description in one sentence
     * @param keys     the keys that a scene can set
     */
    protected EffectKind(String name, String sentence, Key<?>... keys) {
        super(name, sentence, keys);
    }

    /**
     * Builds the effect and adds it to the scene.
     *
     * @param values the keys' values from the scene, already checked
     * @param scene  the scene being built
     */
    public abstract void build(Values values, EffectContext scene);

    /** @return a warning for the person who runs a scene with this number of particles, if there is one */
    public Optional<String> remark(int particles) {
        return Optional.empty();
    }

    /** @return the ids of particles and shapes that these values name */
    public List<String> particles(Values values) {
        return List.of();
    }

    /** @return names of effects of which the scene must have at least one, as wind needs drag; may be empty */
    public List<String> needs() {
        return List.of();
    }

    /** @return names of effects that the scene must not have */
    public List<String> excludes() {
        return List.of();
    }

    /** @return whether a scene may name the effect more than once */
    public boolean isRepeatable() {
        return false;
    }
}
