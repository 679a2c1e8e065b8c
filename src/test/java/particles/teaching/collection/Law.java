package particles.teaching.collection;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import particles.law.Effect;
import particles.law.Particles;

/** A force law of the collection, put together from what students write into the methods of one. */
final class Law implements Effect {
    private final String name;
    private final Set<Trait> traits = EnumSet.noneOf(Trait.class);
    private boolean velocities;
    private Force force = (s, t, f) -> { };
    private Amount energy = (s, t) -> 0;
    private Amount heat = (s, t) -> 0;
    private Amount driven = (s, t) -> 0;

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

    private Law(String name, Trait... traits) {
        this.name = name;
        this.traits.addAll(List.of(traits));
    }

    static Law law(String name, Trait... traits) {
        return new Law(name, traits);
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

    Law driven(Amount driven) {
        this.driven = driven;
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

    static double distance(double[] s, int x, int y) {
        return Math.sqrt((s[x] - s[y]) * (s[x] - s[y]) + (s[x + 1] - s[y + 1]) * (s[x + 1] - s[y + 1])
                + (s[x + 2] - s[y + 2]) * (s[x + 2] - s[y + 2]));
    }

    /** Each pair i &lt; j once, with the force on i along r = x_j - x_i, and that on j times a factor. */
    static Force pairs(Particles p, double partner, Pair along) {
        return (s, t, f) -> {
            for (int i = 0; i < p.count(); i++) {
                for (int j = i + 1; j < p.count(); j++) {
                    double r = distance(s, 6 * i, 6 * j);
                    double size = along.of(r, p.mass(i) * p.mass(j)) / r;
                    for (int c = 0; c < 3; c++) {
                        f[6 * i + 3 + c] += size * (s[6 * j + c] - s[6 * i + c]);
                        f[6 * j + 3 + c] += partner * size * (s[6 * j + c] - s[6 * i + c]);
                    }
                }
            }
        };
    }

    /** Each particle asks all others, itself too if it likes, and pushes only itself. */
    static Force own(Particles p, int first, boolean itself, Pair along) {
        return (s, t, f) -> {
            for (int i = 0; i < p.count(); i++) {
                for (int j = first < 0 ? i + 1 : first; j < p.count(); j++) {
                    if (i != j || itself) {
                        double r = distance(s, 6 * i, 6 * j);
                        double size = along.of(r, p.mass(i) * p.mass(j)) / r;
                        for (int c = 0; c < 3; c++) {
                            f[6 * i + 3 + c] += size * (s[6 * j + c] - s[6 * i + c]);
                        }
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
                    sum += energy.of(distance(s, 6 * i, 6 * j), p.mass(i) * p.mass(j));
                }
            }
            return sum;
        };
    }

    /** The sum of the squares of three entries from k on. */
    static double square(double[] s, int k) {
        return s[k] * s[k] + s[k + 1] * s[k + 1] + s[k + 2] * s[k + 2];
    }

    /** Adds a factor times three entries from k on to the force of the particle at x. */
    static void push(double[] f, int x, double factor, double[] s, int k) {
        for (int c = 0; c < 3; c++) {
            f[x + 3 + c] += factor * s[k + c];
        }
    }

    @Override
    public String getName() {
        return name;
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

    @Override
    public double getDrivenPower(double[] state, double time) {
        return driven.of(state, time);
    }
}
