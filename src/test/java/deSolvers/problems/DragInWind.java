package deSolvers.problems;

/**
 * Independent springs with drag in a wind: x'' = -k x - c (v - w(t)), w = sin(2t), with k = 1, 1.25, 1.5, ... along the
 * state. The acceleration depends on position, velocity and time; any number of blocks of any dimension. <p>x =
 * e<sup>-ct/2</sup> (A cos q t + B sin q t) + P cos 2t + Q sin 2t with q<sup>2</sup> = k - c<sup>2</sup>/4, (k - 4) P +
 * 2 c Q = 0 and (k - 4) Q - 2 c P = c, from x = 1, v = 0.
 */
public final class DragInWind extends SecondOrderProblem {
    private static final double DRAG = 0.4;
    private static final double NU = 2;

    private final int d;
    private final int blocks;

    /**
     * @param d      positions in a block
     * @param blocks how many blocks; 0 is a state of size 0
     */
    public DragInWind(int d, int blocks) {
        super(d, new double[2 * d * blocks]);
        this.d = d;
        this.blocks = blocks;
        startAt(0);
    }

    private static double stiffness(int component) {
        return 1 + component / 4.0;
    }

    @Override
    public double[] exactState(double t) {
        double[] s = new double[2 * d * blocks];
        for (int j = 0; j < d * blocks; j++) {
            double k = stiffness(j);
            double g = DRAG / 2;
            double q = Math.sqrt(k - g * g);
            double m = k - NU * NU;
            double r = DRAG * NU;
            double p = -r * DRAG / (m * m + r * r);
            double u = m * DRAG / (m * m + r * r);
            double a = 1 - p;
            double b = (g * a - NU * u) / q;
            double e = StrictMath.exp(-g * t);
            double c = StrictMath.cos(q * t);
            double z = StrictMath.sin(q * t);
            double c2 = StrictMath.cos(NU * t);
            double z2 = StrictMath.sin(NU * t);
            int x = j / d * 2 * d + j % d;
            s[x] = e * (a * c + b * z) + p * c2 + u * z2;
            s[x + d] = e * ((b * q - g * a) * c - (a * q + g * b) * z) + NU * (u * c2 - p * z2);
        }
        return s;
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        double wind = StrictMath.sin(NU * t);
        for (int j = 0; j < d * blocks; j++) {
            int x = j / d * 2 * d + j % d;
            dSdt[x + d] = -stiffness(j) * s[x] - DRAG * (s[x + d] - wind);
        }
    }
}
