package deSolvers.problems;

import org.hipparchus.special.elliptic.jacobi.CopolarN;
import org.hipparchus.special.elliptic.jacobi.JacobiEllipticBuilder;
import org.hipparchus.special.elliptic.legendre.LegendreEllipticIntegral;

/** A pendulum, theta'' = -sin theta, released at rest. */
public final class Pendulum extends SecondOrderProblem {
    /** Nearer to pi, round-off decides when it falls. */
    private static final double LARGEST = 3.14;

    private final double release;

    /**
     * @param release the angle at t = 0 (rad)
     * @throws IllegalArgumentException if it is larger than 3.14, where it hardly begins to fall
     */
    public Pendulum(double release) {
        super(1, release, 0);
        if (!(Math.abs(release) <= LARGEST)) {
            throw new IllegalArgumentException("a release at " + release + " rad; at most " + LARGEST);
        }
        this.release = release;
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        dSdt[1] = -StrictMath.sin(s[0]);
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    /** sin(theta/2) = k sn(K + t, k) with k = sin(release/2): Jacobi's elliptic function, at rest at t = 0. */
    @Override
    public double[] exactState(double t) {
        double k = StrictMath.sin(release / 2);
        CopolarN elliptic = JacobiEllipticBuilder.build(k * k).valuesN(LegendreEllipticIntegral.bigK(k * k) + t);
        return new double[] {2 * StrictMath.asin(k * elliptic.sn()), 2 * k * elliptic.cn()};
    }
}
