package particles.teaching.collection;

import java.util.function.Function;
import particles.law.Effect;
import particles.law.Particles;

/**
 * One force law of the collection.
 *
 * @param sentence what its keys say that it is
 * @param about    what it is, or what is wrong with it
 * @param cause    words, as a regular expression, that the report of a wrong one has to contain; empty for a right one
 * @param maker    makes it for some particles
 */
record EffectSpecimen(String sentence, String about, String cause, Function<Particles, Effect> maker) {

    static EffectSpecimen right(String sentence, String about, Function<Particles, Effect> maker) {
        return new EffectSpecimen(sentence, about, "", maker);
    }

    static EffectSpecimen wrong(String sentence, String about, String cause, Function<Particles, Effect> maker) {
        return new EffectSpecimen(sentence, about, cause, maker);
    }
}
