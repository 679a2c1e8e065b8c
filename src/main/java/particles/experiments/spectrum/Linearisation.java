package particles.experiments.spectrum;

import deSolvers.implicit.ForceJacobian;
import deSolvers.linear.SolverWork;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.law.Reaction;

/**
 * The linear equations of small motions about a system's present state: x'' = A x + B v for the particles that can
 * move. In the coordinates q = M<sup>1/2</sup> x the matrix A of forces with a potential is symmetric. In the pair (w
 * q, q') with a typical angular frequency w both halves are of one size, and an undamped system's matrix is close to
 * skew.
 */
final class Linearisation {
    private static final long SEED = 715;

    private final ParticleSystem system;
    private final ForceJacobian jacobian;
    private final int[] places;                         // of the coordinates among those of all particles
    private final double[] rootMasses;
    private final double[] displacement;
    private final double[] velocity;
    private final double[] force;
    private final double frequency;

    /** @param system the system in its present state; neither state nor time is changed */
    Linearisation(ParticleSystem system) {
        this.system = system;
        Particles particles = system.getParticles();
        places = IntStream.range(0, particles.count()).filter(i -> !particles.isFixed(i))
                .flatMap(i -> IntStream.range(3 * i, 3 * i + 3)).toArray();
        rootMasses = Arrays.stream(places).mapToDouble(place -> Math.sqrt(particles.mass(place / 3))).toArray();
        displacement = new double[3 * particles.count()];
        velocity = new double[3 * particles.count()];
        force = new double[3 * particles.count()];
        double[] slope = new double[system.getStateSize()];
        system.getStateDerivative(slope);
        jacobian = new ForceJacobian(new SolverWork(), slope.length, system::getStateDerivative);
        jacobian.setUp(system, system.getStateArray(), slope, false);
        frequency = typicalFrequency();
    }

    /** @return the number of coordinates, three for each particle that can move */
    int coordinates() {
        return places.length;
    }

    /** @return whether A is symmetric and B is 0: all forces have potentials, and no reaction answers them */
    boolean isConservative() {
        return system.getEffects().stream().allMatch(effect -> !effect.dependsOnVelocity()
                && effect.getTraits().contains(Trait.CONSERVATIVE))
                && system.getReactions().stream().noneMatch(Reaction::isActive);
    }

    /** @return w (1/s), an angular frequency of the system's size; 1 if there is no restoring force */
    double getFrequency() {
        return frequency;
    }

    private double typicalFrequency() {
        double[] image = new double[coordinates()];
        stiffness(random(coordinates()), image);
        return norm(image) == 0 ? 1 : Math.sqrt(norm(image));
    }

    /** @return a direction of length 1 without preference, the same every time */
    static double[] random(int size) {
        SplittableRandom random = new SplittableRandom(SEED);
        double[] q = new double[size];
        for (int k = 0; k < size; k++) {
            q[k] = random.nextDouble() - 0.5;
        }
        return divided(q, norm(q));
    }

    /** @return a vector divided by a number */
    static double[] divided(double[] a, double by) {
        return Arrays.stream(a).map(x -> x / by).toArray();
    }

    /** Minus the acceleration that a displacement makes: result = -M^(1/2) A M^(-1/2) q. */
    void stiffness(double[] q, double[] result) {
        multiply(q, 0, 1, new double[q.length], 0);
        deceleration(result);
    }

    /** Minus the acceleration that a velocity makes: result = -M^(1/2) B M^(-1/2) p. */
    void damping(double[] p, double[] result) {
        multiply(new double[p.length], 0, 1, p, 0);
        deceleration(result);
    }

    private void deceleration(double[] result) {
        Arrays.setAll(result, k -> -force[places[k]] / rootMasses[k]);
    }

    /**
     * One multiplication with the whole matrix, (w q, p)' = (w p, M^(1/2) (A x + B v));
     * twice as many doubles as coordinates.
     */
    void derivative(double[] y, double[] result) {
        int n = places.length;
        multiply(y, 0, 1 / frequency, y, n);
        for (int k = 0; k < n; k++) {
            result[k] = frequency * y[n + k];
            result[n + k] = force[places[k]] / rootMasses[k];
        }
    }

    private void multiply(double[] q, int fromQ, double scale, double[] p, int fromP) {
        for (int k = 0; k < places.length; k++) {
            displacement[places[k]] = scale * q[fromQ + k] / rootMasses[k];
            velocity[places[k]] = p[fromP + k] / rootMasses[k];
        }
        jacobian.multiply(displacement, velocity, force);
    }

    /**
     * @param q   coordinates from an offset on
     * @param p   their velocities from an offset on
     * @return the direction in the state space
     */
    double[] inState(double[] q, double[] p) {
        double[] state = new double[system.getStateSize()];
        for (int k = 0; k < places.length; k++) {
            int at = Particles.STRIDE * (places[k] / 3) + places[k] % 3;
            state[at] = q[k] / rootMasses[k];
            state[at + 3] = p[k] / rootMasses[k];
        }
        return state;
    }

    static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int k = 0; k < a.length; k++) {
            sum += a[k] * b[k];
        }
        return sum;
    }

    static double norm(double[] a) {
        return Math.sqrt(dot(a, a));
    }
}
