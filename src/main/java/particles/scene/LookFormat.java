package particles.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import particles.Look;
import particles.scene.spec.Key;
import particles.scene.spec.MappingType;
import particles.scene.spec.NameType;
import particles.scene.spec.NumberType;
import particles.scene.spec.TextType;
import particles.scene.spec.Values;

/** What a scene says of how it is drawn. */
final class LookFormat {
    private static final TextType COLOUR = TextType.of("a colour '#rrggbb' in quotes", "^#[0-9a-fA-F]{6}$");
    private static final List<String> SHOWN = Arrays.stream(Look.Shown.values()).map(LookFormat::nameOf).toList();
    private static final Look STANDARD = Look.STANDARD;

    static final Key<String> PARTICLES = Key.withDefault("particles", NameType.of("choice", SHOWN),
            nameOf(STANDARD.particles()), "Which particles are drawn as balls.");
    static final Key<String> SPRINGS = Key.withDefault("springs", NameType.of("choice", SHOWN),
            nameOf(STANDARD.springs()), "Which springs are drawn, coloured by their strain.");
    static final Key<Double> PARTICLE_RADIUS = Key.withDefault("particleRadius", NumberType.notNegative("m"),
            STANDARD.particleRadius(), "The radius of a ball (m); 0 for one that suits the scene's size.");
    static final Key<Double> STRAIN_RANGE = Key.withDefault("strainRange", NumberType.positive(""), STANDARD.strainRange(),
            "The stretch, as a part of the rest length, at which a spring has its full colour.");
    static final Key<String> PARTICLE_COLOUR = colour("particleColour", STANDARD.particleColour(),
            "The colour of particles.");
    static final Key<String> FIXED_COLOUR = colour("fixedColour", STANDARD.fixedColour(), "The colour of fixed particles.");
    static final Key<String> FRONT_COLOUR = colour("frontColour", STANDARD.frontColour(),
            "The colour of a surface's front.");
    static final Key<String> BACK_COLOUR = colour("backColour", STANDARD.backColour(), "The colour of a surface's back.");

    static final MappingType TYPE = MappingType.of("the look", PARTICLES, SPRINGS, PARTICLE_RADIUS, STRAIN_RANGE,
            PARTICLE_COLOUR, FIXED_COLOUR, FRONT_COLOUR, BACK_COLOUR);

    private LookFormat() {
    }

    static Look of(Values values) {
        return new Look(shown(values.get(PARTICLES)), shown(values.get(SPRINGS)), values.get(PARTICLE_RADIUS),
                values.get(STRAIN_RANGE), rgb(values.get(PARTICLE_COLOUR)), rgb(values.get(FIXED_COLOUR)),
                rgb(values.get(FRONT_COLOUR)), rgb(values.get(BACK_COLOUR)));
    }

    private static Key<String> colour(String name, int standard, String sentence) {
        return Key.withDefault(name, COLOUR, String.format("#%06x", standard), sentence);
    }

    private static int rgb(String colour) {
        return Integer.parseInt(colour.substring(1), 16);
    }

    private static String nameOf(Look.Shown shown) {
        return shown.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static Look.Shown shown(String name) {
        return Look.Shown.valueOf(name.toUpperCase(Locale.ROOT).replace('-', '_'));
    }
}
