package particles.output.painters;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.view.SpringView;

/** What a frame needs to know, copied from a running simulation so that it can be drawn beside it. */
public final class FrameState {
    /** Which state of the springs it has; the observer counts. */
    public int structure;
    public double time;
    public int particles;
    /** Three entries a particle. */
    public double[] positions = {};
    public boolean[] fixed = {};
    public int springs;
    /** Indices of particles. */
    public int[] from = {};
    public int[] to = {};
    public double[] restLength = {};
    /** Which of them are rods. */
    public boolean[] rigid = {};
    /** When particles came into being and are to die of age (s); only where they are asked for. */
    public double[] birth = {};
    public double[] death = {};
    /**
     * Where particles were, the oldest sample first, and the index of each in the newest; none where all are the same.
     */
    public TrailSample[] trail = {};
    public int[] trailIndex = {};
    /** What is written below the title, line by line; the first line is a warning. */
    public List<String> notes = List.of();

    /**
     * Copies the places.
     *
     * @param state in the layout of the system's state
     */
    public void take(double[] state, int count, double time) {
        this.time = time;
        notes = List.of();
        trail = new TrailSample[0];
        particles = count;
        if (positions.length < 3 * count) {
            positions = new double[3 * count];
        }
        for (int i = 0, x = 0; i < 3 * count; i += 3, x += Particles.STRIDE) {
            positions[i] = state[x];
            positions[i + 1] = state[x + 1];
            positions[i + 2] = state[x + 2];
        }
    }

    /**
     * Copies what changes only when rules change it: springs and rods, and which particles are fixed.
     *
     * @param withLives whether it is asked for when particles were born and when they die
     */
    public void takeStructure(ParticleSystem system, boolean withLives) {
        int count = system.getParticles().count();
        fixed = Arrays.copyOf(fixed, count);
        for (int i = 0; i < count; i++) {
            fixed[i] = system.getParticles().isFixed(i);
        }
        if (withLives) {
            birth = new double[count];
            death = new double[count];
            for (int i = 0; i < count; i++) {
                birth[i] = system.getParticles().birthTime(i);
                death[i] = system.getParticles().deathTime(i);
            }
        }
        List<SpringView> views = Stream.concat(system.getEffects().stream(), system.getReactions().stream())
                .filter(SpringView.class::isInstance).map(SpringView.class::cast).toList();
        int needed = views.stream().mapToInt(SpringView::springCount).sum();
        if (from.length < needed) {
            from = new int[needed];
            to = new int[needed];
            restLength = new double[needed];
            rigid = new boolean[needed];
        }
        springs = 0;
        for (SpringView view : views) {
            for (int s = 0; s < view.springCount(); s++) {
                from[springs] = view.from(s);
                to[springs] = view.to(s);
                restLength[springs] = view.restLength(s);
                rigid[springs] = view.stiffness(s) == Double.POSITIVE_INFINITY;
                springs++;
            }
        }
    }
}
