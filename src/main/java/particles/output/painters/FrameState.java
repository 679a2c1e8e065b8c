package particles.output.painters;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.view.ParticleMark;
import particles.view.SpringList;

/** A snapshot of a running simulation, so that a frame can be drawn in another thread. */
public final class FrameState {
    /** The version of the springs. */
    public int structure;
    /** The simulated time (s). */
    public double time;
    /** The number of particles. */
    public int particles;
    /** The positions of particles, three entries each (m). */
    public double[] positions = {};
    /** Whether each particle is fixed. */
    public boolean[] fixed = {};
    /** The springs and rods. */
    public SpringList springs = SpringList.NONE;
    /** The times of birth of particles (s), if requested. */
    public double[] birth = {};
    /** The times of death of particles (s), if requested. */
    public double[] death = {};
    /** Earlier positions, the latest sample first. */
    public List<TrailSample> trail = List.of();
    /** The ids of particles. */
    public String[] ids = {};
    /** Three entries a particle (m/s); only where arrows are drawn. */
    public double[] velocities = {};
    /** The own style of each particle, or null. */
    ParticleMark[] marks = {};
    /** The lines below the title; the first one is a warning. */
    public List<String> notes = List.of();

    /**
     * Copies the positions.
     *
     * @param state          a state in the layout of the system's state
     * @param withVelocities whether arrows are drawn
     */
    public void take(double[] state, int count, double time, boolean withVelocities) {
        this.time = time;
        particles = count;
        positions = new double[3 * count];
        for (int i = 0, x = 0; i < 3 * count; i += 3, x += Particles.STRIDE) {
            positions[i] = state[x];
            positions[i + 1] = state[x + 1];
            positions[i + 2] = state[x + 2];
        }
        if (withVelocities) {
            velocities = new double[3 * count];
            for (int i = 0, v = 3; i < 3 * count; i += 3, v += Particles.STRIDE) {
                System.arraycopy(state, v, velocities, i, 3);
            }
        }
    }

    /**
     * Copies the data that only rules change: springs, rods and fixed particles.
     *
     * @param withLives whether times of birth and death are needed
     * @param marked    particles that are drawn in their own way
     */
    public void takeStructure(ParticleSystem system, boolean withLives, List<ParticleMark> marked) {
        int count = system.getParticles().count();
        Map<String, ParticleMark> byId = marked.stream().collect(Collectors.toMap(ParticleMark::particle, mark -> mark,
                (first, second) -> first));
        ids = IntStream.range(0, count).mapToObj(system.getParticles()::id).toArray(String[]::new);
        marks = Arrays.stream(ids).map(byId::get).toArray(ParticleMark[]::new);
        fixed = new boolean[count];
        birth = new double[withLives ? count : 0];
        death = new double[birth.length];
        for (int i = 0; i < count; i++) {
            fixed[i] = system.getParticles().isFixed(i);
            if (withLives) {
                birth[i] = system.getParticles().birthTime(i);
                death[i] = system.getParticles().deathTime(i);
            }
        }
        springs = SpringList.of(Stream.concat(system.getEffects().stream(), system.getReactions().stream()));
    }

    /** @return the position of particle i (m) */
    public Vector3 place(int i) {
        return vector(positions, i);
    }

    /** @return where particle i was at the samples of the trail, back to the first one without it (m) */
    public List<Vector3> path(int i) {
        List<Vector3> path = new ArrayList<>();
        int at = i;
        for (TrailSample sample : trail) {
            at = sample.index(ids[i], at);
            if (at < 0) {
                break;
            }
            float[] places = sample.places();
            path.add(new Vector3(places[3 * at], places[3 * at + 1], places[3 * at + 2]));
        }
        return path;
    }

    /** @return the velocity of particle i (m/s); only where arrows are drawn */
    public Vector3 velocity(int i) {
        return vector(velocities, i);
    }

    private static Vector3 vector(double[] numbers, int i) {
        return Vector3.at(numbers, 3 * i);
    }

    /** Shares the springs, fixed particles, lives and marks of another state, which nobody changes any more. */
    public void shareStructure(FrameState other) {
        structure = other.structure;
        ids = other.ids;
        fixed = other.fixed;
        birth = other.birth;
        death = other.death;
        springs = other.springs;
        marks = other.marks;
    }

    private Optional<ParticleMark> mark(int particle) {
        return particle < marks.length ? Optional.ofNullable(marks[particle]) : Optional.empty();
    }

    /** @return the colour of particle i, 0xRRGGBB: its own, or that of all others */
    public int colour(int i, int others) {
        return mark(i).map(mark -> mark.colour().orElse(others)).orElse(others);
    }

    /** @return the radius of particle i's ball (m): its own, or that of all others */
    public double radius(int i, double others) {
        return mark(i).map(ParticleMark::radius).filter(radius -> radius > 0).orElse(others);
    }

    /** @return the text beside particle i; empty for none */
    public String label(int i) {
        return mark(i).map(ParticleMark::label).orElse("");
    }
}
