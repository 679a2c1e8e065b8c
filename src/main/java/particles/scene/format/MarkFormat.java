package particles.scene.format;

import java.util.OptionalInt;
import particles.scene.parts.SpringDescription;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.view.ParticleMark;

/** The keys of a single particle's drawing style. */
public final class MarkFormat {
    public static final Key<String> PARTICLE = SpringDescription.ANY_ID.required("particle",
            "The particle that is drawn in this way, or the id of a shape for all of its particles.");
    static final Key<String> COLOUR = RenderFormat.COLOUR.optional("colour",
            "The colour of the particle and its trail; by default that of its kind.");
    static final Key<Double> RADIUS = NumberType.notNegative("m").withDefault("radius", 0.0,
            "The radius of its ball (m); 0 for the radius of all others.");
    static final Key<String> LABEL = TextType.prose().optional("label", "A text beside it.");

    static final MappingType TYPE = MappingType.of("a mark", PARTICLE, COLOUR, RADIUS, LABEL);

    private MarkFormat() {
    }

    static ParticleMark of(Values values) {
        OptionalInt colour = values.find(COLOUR).map(RenderFormat::rgb).map(OptionalInt::of)
                .orElse(OptionalInt.empty());
        return new ParticleMark(values.get(PARTICLE), colour, values.get(RADIUS), values.find(LABEL).orElse(""));
    }
}
