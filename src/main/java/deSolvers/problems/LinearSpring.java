package deSolvers.problems;

import deSolvers.SecondOrderStateSource;

/** A damped spring in each of three directions. */
final class LinearSpring extends LinearPair implements SecondOrderStateSource {

    /**
     * @param stiffness omega&sup2; (1/s&sup2;)
     * @param damping   c (1/s)
     */
    LinearSpring(double stiffness, double damping) {
        super(0, 1, -stiffness, -damping);
    }

    @Override
    public int getDimension() {
        return 3;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return damping() != 0;
    }
}
