package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.linear.SolverWork;

/**
 * The linearised backward Euler method: f is linearised at the beginning of the step, so that one linear system
 * replaces the nonlinear equation of {@link BackwardEulerSolver},
 * <blockquote>
 * s(t + h) = s(t) + (I - h J)<sup>-1</sup> h f(s(t), t + h), with J = df/ds.
 * </blockquote>
 * If an end of a compressed spring moves sideways, the spring pushes it further that way. This negative stiffness could
 * make the system indefinite, and is left out of J.
 * The linear system is solved to 1e-4 of its right-hand side where it is solved by iterations, so that a free system
 * keeps its momentum to about that, and a factorised one to round-off.
 *
 * <p><b>Order</b> 1.<br>
 * <b>Evaluations</b> 1, and n more for the Jacobian where the source does not know its own
 * ({@link deSolvers.JacobianStateSource}); about 4 more for particles on rods or wires
 * or balls in contact.<br>
 * <b>Stability</b> R(z) = 1/(1 - z), as backward Euler: no limit on the step for linear systems. Nothing guarantees
 * that the nonlinear equation is solved well.<br>
 * <b>When to use</b> cloth and soft bodies in real time, at one step a frame: the method of most cloth simulators. Its
 * numerical damping is strong, and intended. Where the motion matters, {@code backward-euler} solves the equation
 * itself.<br>
 * <b>Source</b> D. Baraff, A. Witkin, <i>Large Steps in Cloth Simulation</i>, SIGGRAPH 1998; for the projection J.
 * Teran, E. Sifakis, G. Irving, R. Fedkiw, <i>Robust Quasistatic Finite Elements and Flesh Simulation</i>, SCA 2005.
 */
public final class LinearisedEulerSolver extends FixedStepSolver {
    private final Newton newton = new Newton();

    @Override
    protected void step(DEStateSource source, double[] s, double deltaT) {
        source.incTime(deltaT);
        newton.solveLinearised(getTransaction(), copy(s), deltaT, s);
    }

    /** @return the work of all steps so far */
    public SolverWork getWork() {
        return newton.getWork();
    }
}
