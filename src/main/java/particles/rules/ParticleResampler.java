package particles.rules;

import java.util.Arrays;
import particles.ParticleSystem;
import particles.Rule;
import particles.effects.neighbours.NeighbourGrid;
import particles.law.Particles;
import particles.law.Require;
import particles.law.SeededRandom;
import particles.law.Vector3;
import particles.view.SpringView;

/**
 * Keeps the density of particles even by births and deaths, the slides' "birth/death rules e.g. to maintain uniform
 * density of samples": at the end of a step two particles that are too close merge, and one without near neighbours
 * splits. Mass and momentum are conserved: a merged particle has both masses, the centre of mass and its velocity; the
 * halves of a split one have equal velocities. A merger loses the kinetic energy of the relative motion.
 *
 * <p>Fixed particles and those with springs neither merge nor split. New particles have new ids, {@code sample[3]}, and
 * the lifetime of the particle they came from, of the heavier one in a merger.
 */
public final class ParticleResampler implements Rule {
    private static final int STRIDE = Particles.STRIDE;

    private final String id;
    private final SpringView springs;
    private final double closest;
    private final double farthest;
    private final double lightest;
    private final SeededRandom random;
    private final NeighbourGrid grid = new NeighbourGrid();
    private int[] partner = {};
    private double[] square = {};                       // squared distance to the partner; infinity without one
    private boolean[] tied = {};
    private long made;

    /**
     * @param id       the prefix of new particles' ids, unused by others
     * @param springs  the springs whose particles are left alone
     * @param closest  particles closer than this merge (m), positive
     * @param farthest a particle without a neighbour within this distance splits into two, half of it apart (m); more
     *                 than twice the closest
     * @param lightest the smallest mass that a split may give (kg), positive
     * @param seed     the seed for the random directions of splits
     * @throws IllegalArgumentException if a number is out of its range
     */
    public ParticleResampler(String id, SpringView springs, double closest, double farthest, double lightest,
            long seed) {
        this.id = id;
        this.springs = springs;
        this.closest = Require.positive("the closest distance", closest);
        this.farthest = farthest;
        if (!(farthest > 2 * closest && farthest <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("the farthest distance has to be more than twice the closest, "
                    + closest + ", not " + farthest);
        }
        this.lightest = Require.positive("the lightest mass", lightest);
        random = new SeededRandom(seed);
    }

    @Override
    public String getName() {
        return "samples";
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        int n = system.getParticles().count();
        findPartners(system, n);
        boolean[] gone = new boolean[n];
        long before = made;
        for (int i = 0; i < n; i++) {
            if (!mayChange(system, i)) {
                continue;
            }
            int other = partner[i];
            if (square[i] < closest * closest && other > i && mayChange(system, other) && partner[other] == i) {
                gone[i] = true;
                gone[other] = true;
                merge(system, i, other);
            } else if (square[i] > farthest * farthest && system.getParticles().mass(i) >= 2 * lightest) {
                gone[i] = true;
                split(system, i);
            }
        }
        if (made > before) {
            system.removeParticles(Arrays.copyOf(gone, system.getParticles().count()));
        }
        return made > before;
    }

    private boolean mayChange(ParticleSystem system, int i) {
        return !tied[i] && !system.getParticles().isFixed(i);
    }

    /** Finds each particle's nearest neighbour within the farthest distance. */
    private void findPartners(ParticleSystem system, int n) {
        int[] near = new int[n];
        partner = new int[n];
        square = new double[n];
        tied = new boolean[n];
        Arrays.fill(square, Double.POSITIVE_INFINITY);
        for (int s = 0; s < springs.springCount(); s++) {
            tied[springs.from(s)] = true;
            tied[springs.to(s)] = true;
        }
        double[] state = system.getOwnState();
        grid.build(state, n, farthest);
        for (int i = 0; i < n; i++) {
            int count = grid.findLater(i, near);
            for (int k = 0; k < count; k++) {
                Vector3 apart = Vector3.at(state, STRIDE * i).minus(Vector3.at(state, STRIDE * near[k]));
                take(i, near[k], apart.dot(apart));
                take(near[k], i, apart.dot(apart));
            }
        }
    }

    private void take(int i, int other, double apart) {
        if (apart < square[i]) {
            square[i] = apart;
            partner[i] = other;
        }
    }

    private void merge(ParticleSystem system, int i, int j) {
        Particles particles = system.getParticles();
        double mass = particles.mass(i) + particles.mass(j);
        double part = particles.mass(j) / mass;
        Vector3 position = between(system.getOwnState(), STRIDE * i, STRIDE * j, part);
        Vector3 velocity = between(system.getOwnState(), STRIDE * i + 3, STRIDE * j + 3, part);
        int heavier = particles.mass(j) > particles.mass(i) ? j : i;
        add(system, mass, position, velocity, heavier);
    }

    private static Vector3 between(double[] state, int a, int b, double part) {
        Vector3 from = Vector3.at(state, a);
        return from.plus(Vector3.at(state, b).minus(from).times(part));
    }

    private void split(ParticleSystem system, int i) {
        double[] state = system.getOwnState();
        Vector3 position = Vector3.at(state, STRIDE * i);
        Vector3 velocity = Vector3.at(state, STRIDE * i + 3);
        Vector3 half = random.nextDirection(new Vector3(0, 1, 0), Math.PI).times(farthest / 4);
        double mass = system.getParticles().mass(i) / 2;
        add(system, mass, position.plus(half), velocity, i);
        add(system, mass, position.minus(half), velocity, i);
    }

    private void add(ParticleSystem system, double mass, Vector3 position, Vector3 velocity, int parent) {
        int i = system.addParticle(id + "[" + made++ + "]", mass, position, velocity, false);
        system.setLife(i, system.getParticles().birthTime(parent), system.getParticles().deathTime(parent));
    }
}
