package particles.scene;

import deSolvers.catalog.SolverCatalog;
import particles.scene.format.OutputDescription.Frames;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.scene.parts.BirthAndDeath;
import particles.scene.parts.ShapeDescription;

/**
 * Estimates the memory of a run before anything is built. The constants were fitted to the smallest heaps in which
 * cloths of 10,000 to 360,000 particles ran, plus a fifth.
 *
 * @param particles the largest number of particles at a time
 * @param springs   the number of springs
 * @param bytes     the estimated memory (bytes)
 */
public record MemoryEstimate(double particles, double springs, double bytes) {
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
        boolean removed = scene.rules().stream().anyMatch(rule -> rule.kind() == BirthAndDeath.KILL);
        // if a rule removes particles, their number is unknown; at least those of one step exist
        double particles = scene.particlesAfter(removed ? scene.deltaT() : scene.duration());
        Frames frames = scene.output().frames();
        double trail = scene.drawing().look().style().longestTrail();
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
            case IMPLICIT -> info.adaptive() ? 6000 + 1200 * growth : 1400 + 400 * growth;
            case EXTRAPOLATION -> 600.0;
            default -> 0.0;
        }).orElse(0.0);
    }
}
