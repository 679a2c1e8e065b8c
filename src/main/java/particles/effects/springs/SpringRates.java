package particles.effects.springs;

import particles.law.Particles;
import particles.view.SpringView;

/**
 * Upper bounds for the vibration and decay rates of a system of springs, from stiffnesses, dampings and masses alone.
 * They hold in every state, and limit the stable step.
 *
 * <p>Stretched or not, a spring is never stiffer in any direction than k, so that the stiffness matrix is bounded by
 * the weighted Laplacian of the springs' graph; Gershgorin's circles bound the eigenvalues of M<sup>-1</sup>L. The same
 * holds for the dampings. (S. Gershgorin 1931; the matrices are in D. Baraff, A. Witkin, "Large steps in cloth
 * simulation", 1998.)
 *
 * @param stiffest    the spring with the largest own omega, or -1 if no spring has an end that can move
 * @param omega       an upper bound for the omega of any vibration of the whole system (rad/s)
 * @param dampingRate an upper bound for the decay rate of any velocity by the springs' damping (1/s)
 */
public record SpringRates(int stiffest, double omega, double dampingRate) {

    /**
     * @param springs   the springs
     * @param particles the particles that they connect
     * @return their rates
     */
    public static SpringRates of(SpringView springs, Particles particles) {
        double[] inverseMasses = particles.getInverseMasses();
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
        return new SpringRates(stiffest, Math.sqrt(square), rate);
    }

    /**
     * @param drag a further decay rate besides the springs' own damping, such as air drag's c/m (1/s)
     * @return an upper bound for the size of every eigenvalue lambda of the linear system, the roots of lambda&sup2; +
     *         c lambda + omega&sup2; = 0 (1/s)
     */
    public double fastest(double drag) {
        double c = dampingRate + drag;
        return c / 2 + Math.sqrt(c * c / 4 + omega * omega);
    }
}
