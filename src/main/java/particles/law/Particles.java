package particles.law;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * The constant data of all particles: id, mass, radius, whether they are fixed. Positions and velocities are in the
 * state: the position of particle i begins at entry 6 i, its velocity at 6 i + 3.
 */
public final class Particles {
    /** Doubles per particle in a state: three positions, three velocities. */
    public static final int STRIDE = 6;

    private final List<Life> lives = new ArrayList<>();
    private double[] masses = new double[8];
    private double[] inverseMasses = new double[8];
    private double[] radii = new double[8];
    private long version;

    private record Life(String id, double birthTime, double deathTime) {
    }

    /** Throws if a position or velocity is not finite, or a fixed particle has a velocity. */
    public static void requirePossible(String id, Vector3 position, Vector3 velocity, boolean fixed) {
        if (!position.isFinite() || !velocity.isFinite()) {
            throw new IllegalArgumentException("particle '" + id + "' has position " + position + " and velocity "
                    + velocity
                    + "; both have to be finite");
        }
        if (fixed && !velocity.isZero()) {
            throw new IllegalArgumentException("particle '" + id + "' is fixed and has velocity " + velocity
                    + "; a fixed particle's velocity is zero");
        }
    }

    /** Throws if the particle is free: only a fixed one can become a moving anchor. */
    public void requireFixed(int particle) {
        if (!isFixed(particle)) {
            throw new IllegalArgumentException("particle '" + id(particle)
                    + "' is free; only a fixed particle can follow a given motion");
        }
    }

    /** Adds a particle and returns its index. */
    public int add(String id, double mass, boolean fixed, double birthTime) {
        if (!(mass > 0) || !(mass <= Double.MAX_VALUE) || !(1 / mass <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("particle '" + id + "' has mass " + mass
                    + "; it has to be positive and finite (a particle that stays where it is, is fixed)");
        }
        int i = count();
        if (i == masses.length) {
            masses = Arrays.copyOf(masses, i + i / 2);
            inverseMasses = Arrays.copyOf(inverseMasses, i + i / 2);
            radii = Arrays.copyOf(radii, i + i / 2);
        }
        lives.add(new Life(id, birthTime, Double.POSITIVE_INFINITY));
        version++;
        masses[i] = mass;
        radii[i] = 0;
        inverseMasses[i] = fixed ? 0 : 1 / mass;
        return i;
    }

    /** Moves a particle's data to a smaller index. */
    public void move(int from, int to) {
        lives.set(to, lives.get(from));
        masses[to] = masses[from];
        inverseMasses[to] = inverseMasses[from];
        radii[to] = radii[from];
    }

    /** Sets the times of birth and death of particle i (s). */
    public void setLife(int i, double birthTime, double deathTime) {
        lives.set(i, new Life(id(i), birthTime, deathTime));
    }

    /** Makes particle i a hard ball of this radius (m). */
    public void setRadius(int i, double radius) {
        radii[i] = radius;
    }

    /** Removes all particles from this index on. */
    public void shrinkTo(int count) {
        lives.subList(count, count()).clear();
        version++;
    }

    /** @return the number of particles */
    public int count() {
        return lives.size();
    }

    /** @return a number that changes whenever particles are added or removed */
    public long getVersion() {
        return version;
    }

    /** @return the id of particle i, unique in the whole run */
    public String id(int i) {
        return lives.get(i).id();
    }

    /** @return the mass of particle i (kg), also if it is fixed */
    public double mass(int i) {
        return masses[i];
    }

    /** @return the radius of particle i (m), if it is a hard ball; 0 for a point */
    public double radius(int i) {
        return radii[i];
    }

    /** @return whether no force moves particle i */
    public boolean isFixed(int i) {
        return inverseMasses[i] == 0;
    }

    /** @return the simulated time at which particle i was born (s) */
    public double birthTime(int i) {
        return lives.get(i).birthTime();
    }

    /** @return the simulated time at which the lifetime of particle i ends (s); infinity if it has no lifetime */
    public double deathTime(int i) {
        return lives.get(i).deathTime();
    }

    /**
     * @return the array of masses itself (kg), for inner loops; the first {@link #count()} entries are valid; do not
     *         change it or keep a reference
     */
    public double[] getMasses() {
        return masses;
    }

    /** @return the array of 1/m (1/kg), 0 for fixed particles; the rules of {@link #getMasses()} apply */
    public double[] getInverseMasses() {
        return inverseMasses;
    }

    /** @return the mass of all free particles (kg) */
    public double freeMass() {
        return sumOfFree(this::mass);
    }

    /** @return the indices of the particles that can move, from the lowest */
    public IntStream free() {
        return IntStream.range(0, count()).filter(i -> !isFixed(i));
    }

    /** @return the sum of something over the particles that can move, from the lowest index */
    public double sumOfFree(IntToDoubleFunction something) {
        double sum = 0;
        for (int i = 0; i < count(); i++) {             // a stream takes several times as long
            sum += isFixed(i) ? 0 : something.applyAsDouble(i);
        }
        return sum;
    }

    /** @return the index of the fastest particle that can move, or of one whose velocity is not a number; 0 if none */
    public int fastest(double[] state) {
        return free().boxed().max(Comparator.comparingDouble(i -> {         // NaN counts as the largest
            Vector3 v = Vector3.at(state, STRIDE * i + 3);
            return v.dot(v);
        })).orElse(0);
    }

    /**
     * @param direction a direction, of length 1 for coordinates in metres
     * @return statistics of all particles' coordinates along it
     */
    public DoubleSummaryStatistics along(double[] state, Vector3 direction) {
        DoubleSummaryStatistics along = new DoubleSummaryStatistics();
        for (int x = 0; x < STRIDE * count(); x += STRIDE) {
            along.accept(direction.x() * state[x] + direction.y() * state[x + 1] + direction.z() * state[x + 2]);
        }
        return along;
    }

    /** The sum of m v&sup2;/2 over all particles that are not fixed, in the order of their indices (J). */
    public double kineticEnergy(double[] state) {
        double twice = 0;
        for (int i = 0, v = 3; i < count(); i++, v += STRIDE) {
            if (inverseMasses[i] != 0) {
                twice += masses[i] * (state[v] * state[v] + state[v + 1] * state[v + 1] + state[v + 2] * state[v + 2]);
            }
        }
        return twice / 2;
    }
}
