package particles.view;

import java.util.List;

/**
 * The drawing style of free particles: kind, colours, trails, day or night.
 *
 * @param kind       the shape of a particle
 * @param ageColours the colours of a glow through a particle's life, evenly spread from its birth to its death,
 *                   0xRRGGBB
 * @param trail      the time for which a trail stays visible (s); 0 for no trails
 * @param night      whether the sky is dark, so that a glow is visible
 * @param arrows     the length of velocity arrows: the distance that a particle covers in this time (s); 0 for none
 * @param marks      particles that are drawn in their own way
 */
public record ParticleStyle(Kind kind, List<Integer> ageColours, double trail, boolean night, double arrows,
        List<ParticleMark> marks) {

    /** The ways of drawing a particle. */
    public enum Kind {
        /** A shaded ball. */
        BALLS,
        /** A dot of a few pixels at any distance. */
        POINTS,
        /** Part of a smooth surface around all particles: drops that flow together where they meet. */
        BLOBS,
        /** A spot of light, added to the background, that fades as the particle grows old. */
        GLOW,
    }

    /** Balls by daylight, without trails. */
    public static final ParticleStyle STANDARD = new ParticleStyle(Kind.BALLS,
            List.of(0xffe9a8, 0xff9d2e, 0xd83a0f, 0x5a1208), 0, false);

    /** All particles alike, without arrows. */
    public ParticleStyle(Kind kind, List<Integer> ageColours, double trail, boolean night) {
        this(kind, ageColours, trail, night, 0, List.of());
    }

    /** Copies the lists. */
    public ParticleStyle {
        ageColours = List.copyOf(ageColours);
        marks = List.copyOf(marks);
    }

    /** @return the same with trails of this duration (s) */
    public ParticleStyle withTrail(double seconds) {
        return new ParticleStyle(kind, ageColours, seconds, night, arrows, marks);
    }
}
