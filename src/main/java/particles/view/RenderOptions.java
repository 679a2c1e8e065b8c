package particles.view;

import java.util.List;
import java.util.Optional;

/**
 * Render options: the parts of a scene that are drawn, and their colours.
 *
 * @param particles      whether particles are drawn
 * @param springs        whether springs are drawn
 * @param particleRadius the radius of a particle as it is drawn (m), positive, or 0 for one that suits the scene's size
 * @param strainRange    the strain (stretch over rest length) at which a spring has the full colour of stretched or
 *                       compressed, positive: 0.1 for 10 %
 * @param colours        the colours
 * @param style          the drawing style of free particles
 */
public record RenderOptions(Visibility particles, Visibility springs, double particleRadius, double strainRange,
        Colours colours, ParticleStyle style) {

    /** The defaults. */
    public static final RenderOptions STANDARD = new RenderOptions(Visibility.BESIDE_SURFACES,
            Visibility.BESIDE_SURFACES, 0, 0.1, new Colours(0xf0a43c, 0x5a6270, 0xd9534f, 0x4a78b5),
            ParticleStyle.STANDARD);

    /**
     * Colours, 0xRRGGBB.
     *
     * @param particle the colour of particles and of their trails
     * @param fixed    the colour of fixed particles
     * @param front    the colour of a surface's front
     * @param back     the colour of its back
     * @param springs  the colour of all springs, if they do not show their strain
     * @param background the colour behind everything, in place of a sky
     */
    public record Colours(int particle, int fixed, int front, int back, Optional<Integer> springs,
            Optional<Integer> background) {
        /** With springs that show their strain, under a sky. */
        public Colours(int particle, int fixed, int front, int back) {
            this(particle, fixed, front, back, Optional.empty(), Optional.empty());
        }
    }

    /** Whether particles, or springs, are drawn. */
    public enum Visibility {
        /** All. */
        ALWAYS,
        /**
         * Only particles that do not belong to a surface; only springs with an end that does not, unless they begin on
         * a closed surface.
         */
        BESIDE_SURFACES,
        /** None. */
        NEVER,
    }

    /** @return the same options with another style of particles */
    public RenderOptions withStyle(ParticleStyle other) {
        return new RenderOptions(particles, springs, particleRadius, strainRange, colours, other);
    }

    /**
     * Returns the same options in one colour, to tell pictures beside each other apart.
     *
     * @param colour the colour of particles and surfaces, 0xRRGGBB; springs show no strain
     * @return the new options
     */
    public RenderOptions inOneColour(int colour) {
        return new RenderOptions(particles, springs, particleRadius, Double.MAX_VALUE,
                new Colours(colour, colours.fixed, colour, colour, Optional.empty(), colours.background),
                new ParticleStyle(style.kind(), List.of(colour), style.trail(), style.night()));
    }
}
