package particles.output.painters;

import java.util.ArrayList;
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
import particles.law.Vector3;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.SpringView.SpringList;

/**
 * A snapshot of a running simulation, so that a frame can be drawn in another thread.
 *
 * @param time      the simulated time (s)
 * @param state     the positions and velocities, in the layout of the system's state
 * @param structure the springs, and the particles apart from where they are
 * @param trail     earlier positions, the latest sample first
 * @param notes     the lines below the title; the first one is a warning
 */
public record FrameState(double time, double[] state, FrameStructure structure, List<TrailSample> trail,
        List<String> notes) {

    /** @return the number of particles */
    public int particles() {
        return structure.ids().length;
    }

    /** @return the springs and rods */
    public SpringList springs() {
        return structure.springs();
    }

    /** @return whether particle i is fixed */
    public boolean isFixed(int i) {
        return structure.fixed()[i];
    }

    /** @return the position of particle i (m) */
    public Vector3 place(int i) {
        return Vector3.at(state, Particles.STRIDE * i);
    }

    /** @return the velocity of particle i (m/s) */
    public Vector3 velocity(int i) {
        return Vector3.at(state, Particles.STRIDE * i + 3);
    }

    /** @return where a camera sees each particle */
    Place[] places(CameraProjection view) {
        return IntStream.range(0, particles()).mapToObj(i -> view.place(place(i))).toArray(Place[]::new);
    }

    /** @return where particle i was at the samples of the trail, back to the first one without it (m) */
    public List<Vector3> path(int i) {
        List<Vector3> path = new ArrayList<>();
        int at = i;
        for (TrailSample sample : trail) {
            at = sample.index(structure.ids()[i], at);
            if (at < 0) {
                break;
            }
            float[] places = sample.places();
            path.add(new Vector3(places[3 * at], places[3 * at + 1], places[3 * at + 2]));
        }
        return path;
    }

    /**
     * The positions of all particles at a time; nobody changes it any more, so that threads can share it.
     *
     * @param time   the time (s)
     * @param places three entries a particle (m)
     * @param ids    the ids of the particles
     */
    public record TrailSample(double time, float[] places, String[] ids) {

        /**
         * @param later its index at a later time: particles keep their order, and new ones are the last
         * @return the index of a particle, or -1 if it was not there
         */
        int index(String id, int later) {
            for (int i = later; i < ids.length; i++) {
                if (ids[i].equals(id)) {
                    return i;
                }
            }
            return -1;
        }
    }

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
        public int colour(int i, int others) {
            return mark(i).flatMap(ParticleMark::colour).orElse(others);
        }

        /** @return the radius of particle i's ball (m): its own, or that of all others */
        public double radius(int i, double others) {
            return mark(i).map(ParticleMark::radius).filter(radius -> radius > 0).orElse(others);
        }

        /** @return the time for which particle i's trail stays visible (s): its own, or that of all others */
        double trail(int i, double others) {
            return mark(i).flatMap(ParticleMark::trail).orElse(others);
        }

        /** @return the text beside particle i; empty for none */
        public String label(int i) {
            return mark(i).map(ParticleMark::label).orElse("");
        }
    }
}
