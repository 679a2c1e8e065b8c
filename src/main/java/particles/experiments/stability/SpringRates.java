package particles.experiments.stability;

import particles.law.Particles;
import particles.view.SpringView;

/**
 * How fast a system of springs can vibrate, from stiffnesses, dampings and masses alone: what the stability of a step
 * depends on, whatever the system does at the moment.
 *
 * <p>Stretched or not, a spring is never stiffer in any direction than k, so that the stiffness matrix is bounded by
 * the weighted Laplacian of the springs' graph; Gershgorin's circles bound the eigenvalues of M<sup>-1</sup>L. The same
 * holds for the dampings. (S. Gershgorin 1931; the matrices are in D. Baraff, A. Witkin, "Large steps in cloth
 * simulation", 1998.)
 *
 * @param stiffest    the spring with the largest omega of its own, or -1 if there is none with an end that can move
 * @param ownOmega    that omega: of the spring alone with the particles at its ends (rad/s)
 * @param omega       no oscillation of the whole system has a larger omega (rad/s)
 * @param dampingRate no velocity decays faster through the springs' damping (1/s)
 */
public record SpringRates(int stiffest, double ownOmega, double omega, double dampingRate) {

    /**
     * @param springs   the springs
     * @param particles what they connect
     * @return their rates
     */
    public static SpringRates of(SpringView springs, Particles particles) {
        double[] inverseMasses = particles.inverseMasses();
        double[] stiffness = new double[particles.count()];         // the sums of Gershgorin's rows, times the mass
        double[] damping = new double[particles.count()];
        int stiffest = -1;
        double largest = 0;
        for (int s = 0; s < springs.springCount(); s++) {
            int i = springs.from(s);
            int j = springs.to(s);
            // the diagonal, and what couples both ends
            int rows = particles.isFixed(i) || particles.isFixed(j) ? 1 : 2;
            stiffness[i] += rows * springs.stiffness(s);
            stiffness[j] += rows * springs.stiffness(s);
            damping[i] += rows * springs.damping(s);
            damping[j] += rows * springs.damping(s);
            double own = springs.stiffness(s) * (inverseMasses[i] + inverseMasses[j]);
            if (own > largest) {
                largest = own;
                stiffest = s;
            }
        }
        double square = 0;
        double rate = 0;
        for (int i = 0; i < particles.count(); i++) {
            square = Math.max(square, stiffness[i] * inverseMasses[i]);
            rate = Math.max(rate, damping[i] * inverseMasses[i]);
        }
        return new SpringRates(stiffest, Math.sqrt(largest), Math.sqrt(square), rate);
    }

    /**
     * @param drag a decay that acts besides the springs' own damping, such as air drag's c/m (1/s)
     * @return a bound for the size of every eigenvalue lambda of the linear system, the roots of
     *         lambda&sup2; + c lambda + omega&sup2; = 0 (1/s)
     */
    public double fastest(double drag) {
        double c = dampingRate + drag;
        return c / 2 + Math.sqrt(c * c / 4 + omega * omega);
    }
}
