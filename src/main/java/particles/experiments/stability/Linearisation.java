package particles.experiments.stability;

import deSolvers.implicit.ForceJacobian;
import deSolvers.linear.Gmres;
import deSolvers.linear.SolverWork;
import java.util.Arrays;
import java.util.Comparator;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.law.Particles;

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
    /** w (1/s), an angular frequency of the system's size; 1 if there is no restoring force. */
    private double frequency = 1;

    /** @param system the system in its present state; neither state nor time is changed */
    Linearisation(ParticleSystem system) {
        this.system = system;
        Particles particles = system.getParticles();
        places = particles.free()
                .flatMap(i -> IntStream.range(3 * i, 3 * i + 3)).toArray();
        rootMasses = Arrays.stream(places).mapToDouble(place -> Math.sqrt(particles.mass(place / 3))).toArray();
        displacement = new double[3 * particles.count()];
        velocity = new double[3 * particles.count()];
        force = new double[3 * particles.count()];
        double[] slope = new double[system.getStateSize()];
        system.getStateDerivative(slope);
        jacobian = new ForceJacobian(new SolverWork(), slope.length, system::getStateDerivative);
        jacobian.setUp(system, system.getStateArray(), slope, false);
        double restoring = Gmres.norm(derivative(Arrays.copyOf(random(coordinates()), 2 * coordinates())));
        frequency = restoring == 0 ? 1 : Math.sqrt(restoring);
    }

    /** @return the number of coordinates, three for each particle that can move */
    int coordinates() {
        return places.length;
    }

    /** @return a direction of length 1 without preference, the same every time */
    static double[] random(int size) {
        double[] q = new SplittableRandom(SEED).doubles(size, -0.5, 0.5).toArray();
        double length = Gmres.norm(q);
        return Arrays.stream(q).map(x -> x / length).toArray();
    }

    /** @return the damping of a spring that answers velocities of this shape: -p B p / p p (1/s) */
    double damping(double[] p) {
        int n = p.length;
        double[] y = new double[2 * n];
        System.arraycopy(p, 0, y, n, n);
        return -Gmres.dot(p, Arrays.copyOfRange(derivative(y), n, 2 * n)) / Gmres.dot(p, p);
    }

    /** @return y' for y = (w q, q'), one multiplication with the whole matrix: (w q', M^(1/2) (A x + B v)) */
    double[] derivative(double[] y) {
        int n = places.length;
        for (int k = 0; k < n; k++) {
            displacement[places[k]] = y[k] / frequency / rootMasses[k];
            velocity[places[k]] = y[n + k] / rootMasses[k];
        }
        jacobian.multiply(displacement, velocity, force);
        double[] result = new double[2 * n];
        for (int k = 0; k < n; k++) {
            result[k] = frequency * y[n + k];
            result[n + k] = force[places[k]] / rootMasses[k];
        }
        return result;
    }

    /** @return the id of the particle that moves farthest in y = (w q, q') */
    String farthest(double[] y) {
        double[] squares = new double[system.getParticles().count()];
        for (int k = 0; k < places.length; k++) {
            squares[places[k] / 3] += y[k] * y[k] / (rootMasses[k] * rootMasses[k]);
        }
        return system.getParticles().id(IntStream.range(0, squares.length).boxed()
                .max(Comparator.comparingDouble(i -> squares[i])).orElseThrow());
    }
}
