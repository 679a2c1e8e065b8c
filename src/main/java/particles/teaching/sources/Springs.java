package particles.teaching.sources;

import deSolvers.problems.StepMatrix;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/** Particles on springs, x'' = -x in each of three coordinates: the slides' example. */
public final class Springs extends StudentSource implements SecondOrderSource {
    /**
     * The first coordinate starts at (1, 0), the second at (0, 1): one step shows the whole 2 x 2 matrix of the method.
     */
    public Springs() {
        super(1, 0, 0, 0, 1, 0);
    }

    /** @return the matrix by which the steps so far multiplied the state of one coordinate */
    public StepMatrix steps() {
        double[] s = getState();
        return new StepMatrix(s[0], s[1], s[3], s[4], 0);
    }

    /** @return the energy of the first coordinate */
    public double energy() {
        double[] s = getState();
        return (s[0] * s[0] + s[3] * s[3]) / 2;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        for (int k = 0; k < 3; k++) {
            dSdt[k] = s[k + 3];
            dSdt[k + 3] = -s[k];
        }
    }
}
