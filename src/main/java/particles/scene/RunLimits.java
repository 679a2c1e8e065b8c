package particles.scene;

import deSolvers.catalog.SolverCatalog;
import deSolvers.text.Digits;
import java.util.Locale;
import java.util.Optional;
import particles.scene.format.OutputDescription.Frames;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.spec.Values;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/** Limits of a run: numbers of steps and pictures beyond which there can only be a typing error, and its memory. */
public final class RunLimits {
    private static final double MOST_STEPS = 1e10;
    private static final double MOST_FRAMES = 1e6;
    private static final double SOME_FRAMES = 1000;
    private static final double MEGABYTE = 1 << 20;
    /** Nobody is advised to give Java more memory than a large personal computer has. */
    private static final double MOST_GIGABYTES = 64;

    private RunLimits() {
    }

    /** Adds a problem if the run has too many steps; values that are missing or wrong have their own. */
    static void check(Values scene, Problems problems) {
        Optional<Double> deltaT = scene.find(SceneFormat.DELTA_T);
        double duration = scene.find(SceneFormat.DURATION).orElse(0.0);
        if (deltaT.isPresent() && duration / deltaT.get() > MOST_STEPS) {
            problems.add(scene.place(SceneFormat.DURATION), "a duration of " + Digits.exact(duration) + " s is "
                    + Digits.few(duration / deltaT.get()) + " steps of deltaT = " + Digits.exact(deltaT.get())
                    + " s; a run can have at most 1e10");
        }
    }

    /**
     * Checks the number of pictures of a run.
     *
     * @param scene  the scene to run
     * @param option the option that turns pictures off, as typed
     * @throws InvalidInputException if there would be too many
     */
    public static void checkPictures(SceneDescription scene, String option) {
        double frameRate = scene.output().frames().rate();
        if (scene.output().frames().drawn() && scene.duration() * frameRate > MOST_FRAMES) {
            throw new InvalidInputException(scene.values().place(SceneFormat.DURATION) + ": a duration of "
                    + Digits.exact(scene.duration()) + " s needs more than a million pictures at frameRate = "
                    + Digits.exact(frameRate) + "; in the scene, output: {frameRate: "
                    + Digits.roundedDown(SOME_FRAMES / scene.duration(), 2) + "} draws " + (int) SOME_FRAMES + ", and "
                    + option + "=false none");
        }
    }

    /**
     * Adds a problem if the scene does not fit.
     *
     * @param allowed the memory that Java may use (bytes)
     */
    static void checkMemory(SceneDescription scene, double allowed, Problems problems) {
        MemoryEstimate needed = MemoryEstimate.of(scene);
        if (needed.bytes() > allowed) {
            double gigabytes = Math.ceil(needed.bytes() / MEGABYTE / 1024);
            String more = gigabytes > MOST_GIGABYTES ? ""
                    : ", or give Java more memory: JAVA_TOOL_OPTIONS=-Xmx" + (int) gigabytes + "g";
            problems.add(scene.values().place(SceneFormat.SHAPES), String.format(Locale.ROOT, """
                    the scene needs about %s MiB of memory for %.0f particles and %.0f springs with %s, and Java may \
                    use %s MiB; use fewer particles%s""", Digits.few(needed.bytes() / MEGABYTE), needed.particles(),
                    needed.springs(), scene.solver(), Digits.few(allowed / MEGABYTE), more));
        }
    }

    /**
     * Estimates the memory of a run before anything is built. The constants were fitted to the smallest heaps in which
     * cloths of 10,000 to 360,000 particles ran, plus a fifth.
     *
     * @param particles the largest number of particles at a time
     * @param springs   the number of springs
     * @param bytes     the estimated memory (bytes)
     */
    record MemoryEstimate(double particles, double springs, double bytes) {
        /** Java, the program and charts. */
        private static final double BYTES_OF_PROGRAM = 36e6;
        /** Id, state, masses, work arrays of a simple solver, and output. */
        private static final double BYTES_PER_PARTICLE = 800;
        /** Its constants in arrays with spare capacity, and three copies of its data for pictures. */
        private static final double BYTES_PER_SPRING = 100;
        /** A picture being drawn, with depth and shadows, and its copies for film and file. */
        private static final double BYTES_PER_PIXEL = 30;
        /** A position in single precision, and a fourth number if particles are born or die. */
        private static final double BYTES_PER_TRAIL_SAMPLE = 15;
        /** Extra trail samples of up to three pictures waiting to be drawn, plus the newest and oldest one. */
        private static final double SAMPLES_WAITING = 14;
        /** From this number of particles on, the fill-in of an elimination grows with the logarithm of their number. */
        private static final double FEW = 10_000;
        /** Trail samples per frame; impacts add a quarter at most. */
        private static final double SAMPLES_PER_FRAME = 4;
        private static final double MOST_SAMPLES = 1000;

        static MemoryEstimate of(SceneDescription scene) {
            double springs = scene.values().get(SceneFormat.SPRINGS).size()
                    + scene.particles().getShapes().stream().mapToLong(ShapeDescription::springCount).sum();
            boolean removed = scene.rules().stream().anyMatch(RuleKind::removes);
            // if a rule removes particles, their number is unknown; at least those of one step exist
            double particles = scene.particlesAfter(removed ? scene.deltaT() : scene.duration());
            Frames frames = scene.output().frames();
            double trail = scene.drawing().look().style().trail();
            double samples = trail == 0 ? 0
                    : SAMPLES_WAITING + Math.min(MOST_SAMPLES, SAMPLES_PER_FRAME * frames.rate() * trail);
            double pixels = (double) frames.width() * frames.height();
            double perParticle = BYTES_PER_PARTICLE + bytesOfSolver(scene.solver(), particles)
                    + BYTES_PER_TRAIL_SAMPLE * samples;
            return new MemoryEstimate(particles, springs,
                    BYTES_OF_PROGRAM + BYTES_PER_PIXEL * pixels + perParticle * particles
                    + BYTES_PER_SPRING * springs);
        }

        /**
         * Bytes per particle of a solver beyond those of rk4: matrices, stages, columns of an extrapolation. The
         * factors of a nested-dissection elimination grow with n log n; radau has a real and a complex one.
         */
        private static double bytesOfSolver(String name, double particles) {
            double growth = StrictMath.log(Math.max(1, particles / FEW));
            return SolverCatalog.find(name).map(info -> switch (info.family()) {
                case "implicit" -> info.adaptive() ? 6000 + 1200 * growth : 1400 + 400 * growth;
                case "extrapolation" -> 600.0;
                default -> 0.0;
            }).orElse(0.0);
        }
    }
}
