package particles.scene.checks;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.Locale;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.scene.parts.ShapeDescription;
import particles.spec.messages.Problems;

/**
 * How much memory a scene takes while it runs, told from its numbers before anything is built. The bytes are those that
 * were missing when cloths of 10,000 to 360,000 particles ran in the smallest heap in which they would, and a fifth
 * more.
 *
 * @param particles how many there are at a time, at most
 * @param springs   how many there are
 * @param bytes     what all takes
 */
public record MemoryEstimate(double particles, double springs, double bytes) {
    /** Java itself, the program, and charts. */
    private static final double BYTES_OF_PROGRAM = 36e6;
    /** Id, state, masses, the work arrays of a simple solver, and what output needs. */
    private static final double BYTES_PER_PARTICLE = 800;
    /**
     * The constants, in arrays that are up to half as long again, and three copies of what pictures show of a spring.
     */
    private static final double BYTES_PER_SPRING = 100;
    /** A picture being drawn, with depth and shadows, and its copies for film and file. */
    private static final double BYTES_PER_PIXEL = 30;
    /** Where each particle was, in single precision, and a fourth number where some come and go. */
    private static final double BYTES_PER_TRAIL_SAMPLE = 15;
    /**
     * Of trails that pictures still show which are waiting to be drawn, three at most; and the newest and the oldest.
     */
    private static final double SAMPLES_WAITING = 14;
    /** From so many particles on the fill of an elimination is counted as growing, by the logarithm of their number. */
    private static final double FEW = 10_000;
    /** As often as trails are sampled, and as long as they may be. */
    private static final double SAMPLES_PER_FRAME = 4;
    private static final double MOST_SAMPLES = 240;
    private static final double MEGABYTE = 1 << 20;

    static MemoryEstimate of(SceneDescription scene) {
        double particles = scene.particles().size();
        double springs = scene.springs().size();
        for (ShapeDescription shape : scene.shapes()) {
            particles += shape.lattice().size();
            springs += shape.springCount();
        }
        boolean removed = scene.rules().stream().anyMatch(rule -> rule.kind().removes());
        // how many are left, where some are taken away, nobody knows before: those of one step at least
        double duration = removed ? scene.deltaT() : scene.duration();
        particles += scene.rules().stream().mapToDouble(rule -> rule.kind().alive(rule.values(), scene.deltaT(),
                duration)).sum();
        double trail = scene.look().style().trail();
        double samples = trail == 0 ? 0
                : SAMPLES_WAITING + Math.min(MOST_SAMPLES, SAMPLES_PER_FRAME * scene.output().frameRate() * trail);
        double pixels = (double) scene.output().width() * scene.output().height();
        double perParticle = BYTES_PER_PARTICLE + bytesOfSolver(scene.solver(), particles)
                + BYTES_PER_TRAIL_SAMPLE * samples;
        return new MemoryEstimate(particles, springs,
                BYTES_OF_PROGRAM + BYTES_PER_PIXEL * pixels + perParticle * particles
                + BYTES_PER_SPRING * springs);
    }

    /**
     * What a solver takes for a particle beyond what rk4 does: matrices, stages, columns of an extrapolation. The
     * factors of an elimination in nested dissection grow with n log n; radau has a real one and a complex one.
     */
    private static double bytesOfSolver(String name, double particles) {
        if (!SolverCatalog.names().contains(name)) {
            return 0;
        }
        SolverInfo info = SolverCatalog.info(name);
        double growth = StrictMath.log(Math.max(1, particles / FEW));
        return info.family().equals("implicit") ? info.adaptive() ? 6000 + 1200 * growth : 1400 + 400 * growth
                : info.family().equals("extrapolation") ? 600 : 0;
    }

    /** Says so if the scene does not fit. @param allowed how much memory Java may use (bytes) */
    public static void check(SceneDescription scene, double allowed, Problems problems) {
        MemoryEstimate needed = of(scene);
        if (needed.bytes() > allowed) {
            problems.add(scene.places().get(SceneFormat.SHAPES), String.format(Locale.ROOT,
                    "the scene needs about %.0f MiB of memory for %.0f particles and %.0f springs with %s, and"
                            + " Java may use"
                    + " %.0f MiB; use fewer particles, or give Java more memory: JAVA_TOOL_OPTIONS=-Xmx%.0fg",
                    needed.bytes() / MEGABYTE,
                    needed.particles(), needed.springs(), scene.solver(), allowed / MEGABYTE,
                    Math.ceil(needed.bytes() / MEGABYTE / 1024)));
        }
    }
}
