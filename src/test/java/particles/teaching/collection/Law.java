package particles.teaching.collection;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.IntToDoubleFunction;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Vector3;

/** A force law of the collection, put together from what students write into the methods of one. */
final class Law implements Effect {
    private final Set<Trait> traits = EnumSet.noneOf(Trait.class);
    private boolean velocities;
    private Force force = (s, t, f) -> { };
    private Amount energy = (s, t) -> 0;
    private Amount heat = (s, t) -> 0;

    /** The body of addForces. */
    interface Force {
        void add(double[] s, double t, double[] f);
    }

    /** The body of a method that returns an energy or a power. */
    interface Amount {
        double of(double[] s, double t);
    }

    /** What one particle adds, whose entries begin at x. */
    interface One {
        void add(double[] s, double[] f, int x, double m);
    }

    /** A number that each particle adds to. */
    interface Each {
        double of(double[] s, int x, double m);
    }

    /** A number for a pair of particles at the distance r. */
    interface Pair {
        double of(double r, double mm);
    }

    private Law() {
    }

    static Law law(Trait... traits) {
        return new Law().claiming(traits);
    }

    Law force(Force force) {
        this.force = force;
        return this;
    }

    Law energy(Amount energy) {
        this.energy = energy;
        return this;
    }

    Law heat(Amount heat) {
        this.heat = heat;
        return this;
    }

    /** Says that the force depends on velocities. */
    Law moving() {
        velocities = true;
        return this;
    }

    /** Says that it does not. */
    Law still() {
        velocities = false;
        return this;
    }

    /** Claims these properties and no others. */
    Law claiming(Trait... others) {
        traits.clear();
        traits.addAll(List.of(others));
        return this;
    }

    /** Multiplies the force on each particle by a factor of its number. */
    Law times(IntToDoubleFunction factor) {
        Force all = force;
        return force((s, t, f) -> {
            double[] sum = new double[f.length];
            all.add(s, t, sum);
            for (int k = 0; k < f.length; k++) {
                f[k] += factor.applyAsDouble(k / 6) * sum[k];
            }
        });
    }

    static Force each(Particles p, One one) {
        return (s, t, f) -> {
            for (int i = 0; i < p.count(); i++) {
                one.add(s, f, 6 * i, p.mass(i));
            }
        };
    }

    static Amount sum(Particles p, Each each) {
        return (s, t) -> {
            double sum = 0;
            for (int i = 0; i < p.count(); i++) {
                sum += each.of(s, 6 * i, p.mass(i));
            }
            return sum;
        };
    }

    private static double distance(double[] s, int i, int j) {
        return Vector3.at(s, 6 * i).minus(Vector3.at(s, 6 * j)).length();
    }

    /** Each pair i &lt; j once, with the force on i along r = x_j - x_i, and that on j times a factor. */
    static Force pairs(Particles p, double partner, Pair along) {
        return (s, t, f) -> {
            for (int i = 0; i < p.count(); i++) {
                for (int j = i + 1; j < p.count(); j++) {
                    double r = distance(s, i, j);
                    double size = along.of(r, p.mass(i) * p.mass(j)) / r;
                    for (int c = 0; c < 3; c++) {
                        f[6 * i + 3 + c] += size * (s[6 * j + c] - s[6 * i + c]);
                        f[6 * j + 3 + c] += partner * size * (s[6 * j + c] - s[6 * i + c]);
                    }
                }
            }
        };
    }

    static Amount pairEnergy(Particles p, Pair energy) {
        return (s, t) -> {
            double sum = 0;
            for (int i = 0; i < p.count(); i++) {
                for (int j = i + 1; j < p.count(); j++) {
                    sum += energy.of(distance(s, i, j), p.mass(i) * p.mass(j));
                }
            }
            return sum;
        };
    }

    /** The sum of the squares of three entries from k on. */
    static double square(double[] s, int k) {
        return Vector3.at(s, k).dot(Vector3.at(s, k));
    }

    /** Adds a factor times three entries from k on to the force of the particle at x. */
    static void push(double[] f, int x, double factor, double[] s, int k) {
        for (int c = 0; c < 3; c++) {
            f[x + 3 + c] += factor * s[k + c];
        }
    }

    @Override
    public String getName() {
        return "law";
    }

    @Override
    public Set<Trait> getTraits() {
        return traits;
    }

    @Override
    public boolean dependsOnVelocity() {
        return velocities;
    }

    @Override
    public void addForces(double[] state, double time, double[] f) {
        force.add(state, time, f);
    }

    @Override
    public double getPotentialEnergy(double[] state, double time) {
        return energy.of(state, time);
    }

    @Override
    public double getDissipatedPower(double[] state, double time) {
        return heat.of(state, time);
    }
}
