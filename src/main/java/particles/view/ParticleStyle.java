package particles.view;

import java.util.List;
import java.util.Optional;

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

    /** @return the longest time for which a trail stays visible (s); 0 if there are none */
    public double longestTrail() {
        return Math.max(trail, marks.stream().flatMap(mark -> mark.trail().stream()).mapToDouble(Double::doubleValue)
                .max().orElse(0));
    }

    /**
     * The drawing style of one particle that differs from all others.
     *
     * @param particle its id
     * @param colour   its colour and that of its trail, 0xRRGGBB, if it has one of its own
     * @param radius   the radius of its ball (m); 0 for that of all others
     * @param label    the text beside it; empty for none
     * @param trail    the time for which its trail stays visible (s), if it has a time of its own
     */
    public record ParticleMark(String particle, Optional<Integer> colour, double radius, String label,
            Optional<Double> trail) {
        /** A mark of a particle whose trail is as those of all others. */
        public ParticleMark(String particle, Optional<Integer> colour, double radius, String label) {
            this(particle, colour, radius, label, Optional.empty());
        }
    }
}
