package particles.scene.format;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import particles.effects.SharedKeys;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.ShapeDescription;
import particles.scene.parts.SpringDescription;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.ListType;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.messages.Problems;
import particles.view.ParticleStyle;
import particles.view.ParticleStyle.Kind;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;

/** The keys of a scene's render options. */
public final class RenderFormat {
    static final TextType COLOUR = TextType.of("a colour '#rrggbb' in quotes", "^#[0-9a-fA-F]{6}$");
    private static final List<String> SKIES = List.of("day", "night");
    private static final int MOST_COLOURS = 16;
    private static final RenderOptions STANDARD = RenderOptions.STANDARD;

    static final Key<Visibility> PARTICLES = NameType.of("choice", Visibility.class)
            .withDefault("particles", STANDARD.particles(),
            "Which particles are drawn. beside-surfaces: all but those of a surface.");
    static final Key<Kind> PARTICLES_AS = NameType.of("way of drawing", Kind.class).withDefault("particlesAs",
            ParticleStyle.STANDARD.kind(), """
                    How free particles are drawn. balls: shaded; points: dots of the same size at any distance; \
                    blobs: drops that merge into one smooth surface; glow: spots of light that add up and fade with \
                    age if particles have a lifetime.""");
    static final Key<List<String>> AGE_COLOURS = ListType.of("a colour", COLOUR)
            .optional("ageColours",
            "The colours of a glow from birth to death, evenly spaced; by default those of a flame.");
    static final Key<Double> TRAIL = NumberType.notNegative("s").withDefault("trail", ParticleStyle.STANDARD.trail(),
            "The time for which a particle's path stays visible as a fading line (s); 0 for no trail.");
    static final Key<String> SKY = NameType.of("sky", SKIES)
            .optional("sky",
            "day or night; by default night for a glow, which does not show by day, and day otherwise.");
    static final Key<Visibility> SPRINGS = NameType.of("choice", Visibility.class)
            .withDefault("springs", STANDARD.springs(),
            "Which springs and rods are drawn. Stretched springs are red, compressed ones blue.");
    static final Key<Double> PARTICLE_RADIUS = NumberType.notNegative("m").withDefault("particleRadius",
            STANDARD.particleRadius(),
            "The radius of a ball, a single blob or a spot of light (m); 0 to choose it from the scene's size.");
    static final Key<Double> STRAIN_RANGE = NumberType.positive("").withDefault("strainRange", STANDARD.strainRange(),
            "The strain, stretch divided by rest length, at which a spring has its full colour.");
    static final Key<String> PARTICLE_COLOUR = colour("particleColour", STANDARD.colours().particle(),
            "The colour of particles and trails; a glow has its own.");
    static final Key<String> FIXED_COLOUR = colour("fixedColour", STANDARD.colours().fixed(),
            "The colour of fixed particles.");
    static final Key<String> FRONT_COLOUR = colour("frontColour", STANDARD.colours().front(),
            "The colour of a surface's front.");
    static final Key<String> BACK_COLOUR = colour("backColour", STANDARD.colours().back(),
            "The colour of a surface's back.");

    static final Key<String> SPRING_COLOUR = COLOUR.optional("springColour",
            "The colour of all springs; by default it shows their strain.");
    static final Key<String> BACKGROUND = COLOUR.optional("background",
            "The colour behind everything, in place of a sky; text on it is dark or light, as 'sky' says, or as"
            + " suits it.");

    static final Key<Double> VELOCITY_ARROWS = NumberType.notNegative("s").withDefault("velocityArrows", 0.0,
            "Draws each particle's velocity as an arrow, as long as its path in this time (s) at its present speed;"
            + " 0 for no arrows.");
    public static final Key<String> MARKED = SpringDescription.ANY_ID.required("particle",
            "The particle that is drawn in this way, or the id of a shape for all of its particles.");
    private static final Key<String> MARK_COLOUR = COLOUR.optional("colour",
            "The colour of the particle and its trail; by default that of its kind.");
    private static final Key<Double> MARK_RADIUS = NumberType.notNegative("m").withDefault("radius", 0.0,
            "The radius of its ball (m); 0 for the radius of all others.");
    private static final Key<String> LABEL = TextType.prose().optional("label", "A text beside it.");
    private static final Key<Double> MARK_TRAIL = NumberType.notNegative("s").optional("trail",
            "The time for which its path stays visible as a fading line (s); by default that of all others.");
    public static final Key<List<Values>> MARKS = MappingType.of("a mark", MARKED, MARK_COLOUR, MARK_RADIUS,
            LABEL, MARK_TRAIL).list("marks", "Particles with a colour, a size, a label or a trail of their own.");

    static final MappingType TYPE = MappingType.of("the look", PARTICLES, PARTICLES_AS, AGE_COLOURS, TRAIL, SKY,
            SPRINGS, PARTICLE_RADIUS, STRAIN_RANGE,
            PARTICLE_COLOUR, FIXED_COLOUR, FRONT_COLOUR, BACK_COLOUR, SPRING_COLOUR, BACKGROUND, VELOCITY_ARROWS,
            MARKS);

    private RenderFormat() {
    }

    /**
     * @param scene the values in the file, without mistakes
     * @param index its particles
     * @return the look of the scene. Balls have their radius: that of an effect or a rule, or their own; a shape's
     *         mark is that of its particles
     */
    public static RenderOptions of(Values scene, ParticleIndex index) {
        Values look = scene.mapping(SceneFormat.LOOK);
        double radius = Stream.concat(Stream.of(look.get(PARTICLE_RADIUS)),
                Stream.<Chosen<?>>concat(scene.get(SceneFormat.EFFECTS).stream(), scene.get(SceneFormat.RULES).stream())
                .filter(chosen -> chosen.kind().getKeys().stream().anyMatch(key -> key == SharedKeys.BALL_RADIUS))
                .map(chosen -> chosen.values().get(SharedKeys.BALL_RADIUS))).filter(given -> given > 0).findFirst()
                .orElse(0.0);
        Optional<Integer> background = look.find(BACKGROUND).map(RenderFormat::rgb);
        Kind kind = look.get(PARTICLES_AS);
        List<Integer> colours = look.find(AGE_COLOURS).map(all -> all.stream().map(RenderFormat::rgb).toList())
                .orElse(ParticleStyle.STANDARD.ageColours());
        boolean night = look.find(SKY).map("night"::equals).or(() -> background.map(RenderFormat::isDark))
                .orElse(kind == Kind.GLOW);
        return new RenderOptions(look.get(PARTICLES), look.get(SPRINGS), radius, look.get(STRAIN_RANGE),
                new RenderOptions.Colours(rgb(look.get(PARTICLE_COLOUR)), rgb(look.get(FIXED_COLOUR)),
                rgb(look.get(FRONT_COLOUR)), rgb(look.get(BACK_COLOUR)),
                look.find(SPRING_COLOUR).map(RenderFormat::rgb), background), new ParticleStyle(kind, colours,
                look.get(TRAIL), night, look.get(VELOCITY_ARROWS), marks(look.get(MARKS), index)));
    }

    private static List<ParticleMark> marks(List<Values> given, ParticleIndex index) {
        Map<String, ParticleMark> marks = new LinkedHashMap<>();
        Stream.concat(index.getParticles().stream(), index.getShapes().stream().filter(shape ->
                shape.radius().isPresent()).flatMap(ShapeDescription::particles)).forEach(particle ->
                particle.radius().ifPresent(own -> marks.put(particle.id(),
                        new ParticleMark(particle.id(), Optional.empty(), own, ""))));
        for (Values mark : given) {
            String named = mark.get(MARKED);
            index.shape(named).map(shape -> shape.particles().map(ParticleDescription::id)).orElse(Stream.of(named))
                    .forEach(id -> {
                        double before = marks.containsKey(id) ? marks.get(id).radius() : 0;
                        double own = mark.get(MARK_RADIUS);
                        marks.put(id, new ParticleMark(id, mark.find(MARK_COLOUR).map(RenderFormat::rgb),
                                own > 0 ? own : before, mark.find(LABEL).orElse(""), mark.find(MARK_TRAIL)));
                    });
        }
        return List.copyOf(marks.values());
    }

    /** Reports keys that cannot be combined. */
    public static void check(Values values, Problems problems) {
        if (!values.isGiven(AGE_COLOURS) || !values.isIntact(AGE_COLOURS)) {
            return;
        }
        int count = values.find(AGE_COLOURS).orElse(List.of()).size();
        if (count < 1 || count > MOST_COLOURS) {
            problems.add(values.place(AGE_COLOURS), "'ageColours' has " + count
                    + " colours; allowed are 1 to " + MOST_COLOURS);
        }
        if (values.find(PARTICLES_AS).filter(as -> as != Kind.GLOW).isPresent()) {
            problems.add(values.place(AGE_COLOURS),
                    "'ageColours' only works with a glow; add 'particlesAs: glow' or remove it");
        }
    }

    static Key<String> colour(String name, int standard, String sentence) {
        return COLOUR.withDefault(name, String.format("#%06x", standard), sentence);
    }

    /** By the usual weights of red, green and blue in a colour's luminance (ITU-R BT.601). */
    private static boolean isDark(int rgb) {
        return 299 * (rgb >> 16 & 255) + 587 * (rgb >> 8 & 255) + 114 * (rgb & 255) < 128_000;
    }

    static int rgb(String colour) {
        return Integer.parseInt(colour.substring(1), 16);
    }
}
