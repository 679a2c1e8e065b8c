package particles.scene.format;

import java.util.List;
import java.util.Optional;
import particles.scene.parts.SpringDescription;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.messages.Place;

/**
 * The output of a run: pictures, films, plots and the trajectory.
 *
 * @param frames           the pictures
 * @param energy           whether energies are plotted
 * @param phase            the phase-space plot, if there is one
 * @param trajectoryStride write every n-th step to the trajectory; empty for the default
 */
public record OutputDescription(Frames frames, boolean energy, Optional<Phase> phase,
        Optional<Integer> trajectoryStride) {

    /**
     * The pictures of the motion.
     *
     * @param drawn     whether they are drawn
     * @param rate      how many there are for a second of simulated time
     * @param width     their width in pixels
     * @param height    their height in pixels
     * @param animation the largest width of an animated GIF of them in pixels; 0 for none
     * @param film      whether a film is made of them, too
     */
    public record Frames(boolean drawn, double rate, int width, int height, int animation, boolean film) {

        /** @return frames per second of the animation and the film (1/s) */
        public double playbackRate() {
            return rate >= 1 && rate <= 1000 ? rate : 25;
        }
    }

    /**
     * A plot of velocity over position.
     *
     * @param particle the id of the particle
     * @param axis     0 for x, 1 for y, 2 for z, 3 for the angle about another particle
     * @param about    the id of that other particle
     * @param place    its place in the file
     */
    public record Phase(String particle, int axis, Optional<String> about, Place place) {
        private static final List<String> AXES = List.of("x", "y", "z", "angle");
        /** The name of the axis that is an angle. */
        public static final String ANGLE = AXES.get(3);
        public static final Key<String> PARTICLE = SpringDescription.ANY_ID.required("particle",
                "The particle to plot.");
        public static final Key<String> AXIS = NameType.of("axis", AXES).withDefault("axis", "y",
                "The component of position and velocity to plot; or angle, for the angle about another particle.");
        public static final Key<String> ABOUT = SpringDescription.ANY_ID.optional("about",
                "With axis: angle, the particle about which the angle is measured: 0 straight below it,"
                + " counter-clockwise in the x-y plane.");

        static final MappingType TYPE = MappingType.of("the phase-space plot", PARTICLE, AXIS, ABOUT);

        /** @return the plot with these values */
        public static Phase of(Values values) {
            return new Phase(values.get(PARTICLE), AXES.indexOf(values.get(AXIS)), values.find(ABOUT),
                    values.place(PARTICLE));
        }
    }

    public static final Key<Double> FRAME_RATE = NumberType.positive("1/s").withDefault("frameRate", 25.0,
            "Frames per second of simulated time (1/s). From 1 to 1000 /s, animation and film run in simulated time;"
            + " with other rates, such as 1e17 /s for an atom, they show 25 frames a second.");
    /** The widest animation, unless an option asks for another one (pixels). */
    private static final int MOST_ANIMATED = 640;
    /** The shortest side of a picture (pixels). */
    public static final int LEAST_SIDE = 16;
    /** The longest one. */
    public static final int MOST_SIDE = 4096;
    private static final NumberType.Whole SIDE = new NumberType.Whole(LEAST_SIDE, MOST_SIDE);
    static final Key<Integer> WIDTH = SIDE.withDefault("width", 960, "The width of a frame (pixels).");
    static final Key<Integer> HEIGHT = SIDE.withDefault("height", 540, "The height of a frame (pixels).");
    static final Key<Boolean> ANIMATION = FlagType.FLAG.withDefault("animation", true,
            "Whether to write the frames as animation.gif.");
    /** The name of a film in H.264. */
    public static final String MP4 = "mp4";
    /** The kinds of film. */
    public static final List<String> FILMS = List.of("none", MP4);
    static final Key<String> VIDEO = NameType.of("kind of film", FILMS).withDefault("video", FILMS.get(0),
            "mp4: write the frames as film.mp4 too; none: no film.");
    static final Key<Boolean> ENERGY = FlagType.FLAG.withDefault("energy", true,
            "Whether to plot the energies in energy.png.");
    public static final Key<Values> PHASE = Phase.TYPE.optional("phase",
            "Plots velocity against position of one particle in phase.png; no plot if left out.");
    static final Key<Integer> TRAJECTORY_STRIDE = new NumberType.Whole(1, 1_000_000).optional("trajectoryStride",
            "Write every n-th step to trajectory.csv; by default n keeps the file below about 200,000 lines.");

    static final MappingType TYPE = MappingType.of("the output", FRAME_RATE, WIDTH, HEIGHT, ANIMATION, VIDEO, ENERGY,
            PHASE, TRAJECTORY_STRIDE);

    /** @return the output with these values */
    public static OutputDescription of(Values values) {
        return new OutputDescription(new Frames(true, values.get(FRAME_RATE), values.get(WIDTH), values.get(HEIGHT),
                values.get(ANIMATION) ? MOST_ANIMATED : 0, values.get(VIDEO).equals(MP4)),
                values.get(ENERGY), values.find(PHASE).map(Phase::of), values.find(TRAJECTORY_STRIDE));
    }

    /**
     * @param drawn whether there are pictures
     * @param film  whether there is a film of them
     * @return the other files of this output, with these
     */
    public OutputDescription with(boolean drawn, boolean film) {
        return new OutputDescription(new Frames(drawn, frames.rate, frames.width, frames.height,
                drawn ? frames.animation : 0, film), energy, phase, trajectoryStride);
    }

    /** @return the same files with frames, animation and film of this size (pixels) */
    public OutputDescription sized(int width, int height) {
        return new OutputDescription(new Frames(frames.drawn, frames.rate, width, height,
                frames.animation > 0 ? width : 0, frames.film), energy, phase, trajectoryStride);
    }
}
