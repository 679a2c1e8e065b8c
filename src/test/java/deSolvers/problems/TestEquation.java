package deSolvers.problems;

/** s' = lambda s from 1 with lambda = re + i im, as a system of two. */
public final class TestEquation extends ReferenceProblem {
    private final double re;
    private final double im;

    /**
     * @param re real part of lambda (1/s)
     * @param im its imaginary part (1/s)
     */
    public TestEquation(double re, double im) {
        super(1, 0);
        this.re = re;
        this.im = im;
    }

    @Override
    public double[] exactState(double t) {
        double size = StrictMath.exp(re * t);
        return new double[] {size * StrictMath.cos(im * t), size * StrictMath.sin(im * t)};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = re * s[0] - im * s[1];
        dSdt[1] = im * s[0] + re * s[1];
    }
}
