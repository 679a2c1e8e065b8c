package particles.teaching.collection;

import java.util.function.Function;
import particles.law.Effect;
import particles.law.Particles;

/**
 * One force law of the collection.
 *
 * @param about    what it is, or what is wrong with it
 * @param cause    words, as a regular expression, that the report of a wrong one has to contain; empty for a right one
 * @param maker    makes it for some particles
 */
record EffectSpecimen(String about, String cause, Function<Particles, Effect> maker) {

    static EffectSpecimen right(String about, Function<Particles, Effect> maker) {
        return new EffectSpecimen(about, "", maker);
    }

    static EffectSpecimen wrong(String about, String cause, Function<Particles, Effect> maker) {
        return new EffectSpecimen(about, cause, maker);
    }
}
