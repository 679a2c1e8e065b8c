package particles.teaching.effects;

import java.util.function.Function;
import particles.law.Effect;
import particles.law.Particles;

/**
 * A force law to be checked.
 *
 * @param maker    creates it for some particles
 * @param sentence the description in its keys; may be empty
 * @param signed   whether a scene can turn its direction around, by a required key that may be negative
 */
public record EffectLaw(Function<Particles, Effect> maker, String sentence, boolean signed) {

    /** A law without keys or description. */
    public EffectLaw(Function<Particles, Effect> maker) {
        this(maker, "", false);
    }
}
