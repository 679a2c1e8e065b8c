package particles.scene;

import java.util.List;
import java.util.Optional;
import particles.scene.spec.FlagType;
import particles.scene.spec.Key;
import particles.scene.spec.MappingType;
import particles.scene.spec.NameType;
import particles.scene.spec.NumberType;
import particles.scene.spec.Place;
import particles.scene.spec.Values;
import particles.scene.spec.WholeNumberType;

/**
 * What a run of a scene writes.
 *
 * @param frameRate        pictures for a second of simulated time
 * @param width            their width in pixels
 * @param height           their height in pixels
 * @param animation        whether they are also put together to an animation
 * @param energy           whether energies are plotted
 * @param phase            what the phase-space plot shows, if there is one
 * @param trajectoryStride every how many steps the state is written to the trajectory, if the scene says so
 */
public record OutputDescription(double frameRate, int width, int height, boolean animation, boolean energy,
                                Optional<Phase> phase, Optional<Integer> trajectoryStride) {

    /**
     * A plot of velocity over position.
     *
     * @param particle the id of the particle
     * @param axis     0 for x, 1 for y, 2 for z
     * @param place    where the scene says so
     */
    public record Phase(String particle, int axis, Place place) {
        static final Key<String> PARTICLE = Key.required("particle", SpringDescription.ANY_ID,
                "The particle that is looked at.");
        static final Key<String> AXIS = Key.withDefault("axis", NameType.of("axis", List.of("x", "y", "z")), "y",
                "The component of its position and velocity.");

        static final MappingType TYPE = MappingType.of("the phase-space plot", PARTICLE, AXIS);

        static Phase of(Values values) {
            return new Phase(values.get(PARTICLE), "xyz".indexOf(values.get(AXIS)), values.place(PARTICLE));
        }
    }

    static final Key<Double> FRAME_RATE = Key.withDefault("frameRate", NumberType.between(0.001, 1000, "1/s"), 25.0,
            "Pictures for a second of simulated time (1/s).");
    static final Key<Integer> WIDTH = Key.withDefault("width", new WholeNumberType(16, 4096), 960,
            "The pictures' width (pixels).");
    static final Key<Integer> HEIGHT = Key.withDefault("height", new WholeNumberType(16, 4096), 540,
            "The pictures' height (pixels).");
    static final Key<Boolean> ANIMATION = Key.withDefault("animation", FlagType.FLAG, true,
            "Whether the pictures are put together to animation.gif.");
    static final Key<Boolean> ENERGY = Key.withDefault("energy", FlagType.FLAG, true,
            "Whether energies are plotted to energy.png.");
    static final Key<Values> PHASE = Key.optional("phase", Phase.TYPE,
            "Velocity over position of one particle, plotted to phase.png; none where it is not given.");
    static final Key<Integer> TRAJECTORY_STRIDE = Key.optional("trajectoryStride", new WholeNumberType(1, 1_000_000),
            "Every how many steps the state is written to trajectory.csv; where it is not given, as often as the file stays"
            + " below about 200,000 lines.");

    static final MappingType TYPE = MappingType.of("the output", FRAME_RATE, WIDTH, HEIGHT, ANIMATION, ENERGY, PHASE,
            TRAJECTORY_STRIDE);

    static OutputDescription of(Values values) {
        return new OutputDescription(values.get(FRAME_RATE), values.get(WIDTH), values.get(HEIGHT), values.get(ANIMATION),
                values.get(ENERGY), values.find(PHASE).map(Phase::of), values.find(TRAJECTORY_STRIDE));
    }
}
