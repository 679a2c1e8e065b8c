package particles.experiments.problems;

/** The slides' example, x'' = -x from (1, 0): x = cos t. */
public final class Oscillator extends TestProblem {
    /** At (1, 0). */
    public Oscillator() {
        super(1, 0);
    }

    @Override
    protected void accelerate(double[] s, double[] dSdt) {
        dSdt[1] = -s[0];
    }

    /**
     * @param t a time (s)
     * @return the exact state then
     */
    public static double[] exactState(double t) {
        return new double[] {StrictMath.cos(t), -StrictMath.sin(t)};
    }
}
