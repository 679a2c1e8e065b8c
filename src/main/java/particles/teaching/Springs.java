package particles.teaching;

import deSolvers.SecondOrderStateSource;

/** One particle on a spring, x'' = -x in each coordinate, the slides' example three times over. */
final class Springs implements SecondOrderStateSource {
    private final double[] state;
    private double time;
    private int evaluations;

    /** The first coordinate starts at (1, 0), the second at (0, 1): one step shows the whole 2 x 2 matrix of the method. */
    Springs() {
        state = new double[] {1, 0, 0, 0, 1, 0};
    }

    /** @return by how much a step has multiplied areas in state space: the determinant of its matrix */
    double area() {
        return state[0] * state[4] - state[1] * state[3];
    }

    /** @return the larger of the moduli of the matrix's eigenvalues: by how much a step multiplies the amplitude */
    double amplification() {
        double trace = state[0] + state[4];
        double determinant = area();
        double discriminant = trace * trace / 4 - determinant;
        return discriminant <= 0 ? Math.sqrt(determinant) : Math.abs(trace) / 2 + Math.sqrt(discriminant);
    }

    /** @return the energy of the first coordinate */
    double energy() {
        return (state[0] * state[0] + state[3] * state[3]) / 2;
    }

    int evaluations() {
        return evaluations;
    }

    @Override
    public int getDimension() {
        return 3;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    @Override
    public int getStateSize() {
        return state.length;
    }

    @Override
    public void getState(double[] s) {
        System.arraycopy(state, 0, s, 0, state.length);
    }

    @Override
    public void setState(double[] s) {
        System.arraycopy(s, 0, state, 0, state.length);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        evaluations++;
        for (int k = 0; k < 3; k++) {
            dSdt[k] = state[k + 3];
            dSdt[k + 3] = -state[k];
        }
    }

    @Override
    public double getTime() {
        return time;
    }

    @Override
    public void incTime(double deltaT) {
        time += deltaT;
    }
}
