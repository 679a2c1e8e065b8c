package particles.output.painters;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.SpringList;

/**
 * A copy of all that only rules change in a run; frames share it until then.
 *
 * @param ids     the ids of particles
 * @param fixed   whether each particle is fixed
 * @param springs the springs and rods
 * @param births  the times of birth of particles (s)
 * @param deaths  the times of death of particles (s)
 * @param marks   the own style of each particle, or null
 */
public record FrameStructure(String[] ids, boolean[] fixed, SpringList springs, double[] births, double[] deaths,
        ParticleMark[] marks) {

    /** @param marked particles that are drawn in their own way */
    public static FrameStructure of(ParticleSystem system, List<ParticleMark> marked) {
        Particles particles = system.getParticles();
        int count = particles.count();
        Map<String, ParticleMark> byId = marked.stream().collect(Collectors.toMap(ParticleMark::particle,
                Function.identity(), (first, second) -> first));
        boolean[] fixed = new boolean[count];
        for (int i = 0; i < count; i++) {
            fixed[i] = particles.isFixed(i);
        }
        String[] ids = IntStream.range(0, count).mapToObj(particles::id).toArray(String[]::new);
        return new FrameStructure(ids, fixed,
                SpringList.of(Stream.concat(system.getEffects().stream(), system.getReactions().stream())),
                IntStream.range(0, count).mapToDouble(particles::birthTime).toArray(),
                IntStream.range(0, count).mapToDouble(particles::deathTime).toArray(),
                Arrays.stream(ids).map(byId::get).toArray(ParticleMark[]::new));
    }

    private Optional<ParticleMark> mark(int particle) {
        return Optional.ofNullable(marks[particle]);
    }

    /** @return the colour of particle i, 0xRRGGBB: its own, or that of all others */
    int colour(int i, int others) {
        return mark(i).flatMap(ParticleMark::colour).orElse(others);
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
