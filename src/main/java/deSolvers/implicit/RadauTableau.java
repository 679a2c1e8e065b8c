package deSolvers.implicit;

/**
 * The coefficients of the Radau IIA method with three stages and of the change of variables that splits its linear
 * systems: A<sup>-1</sup> = T diag(mu, (re im; -im re)) T<sup>-1</sup>.
 */
final class RadauTableau {
    static final double S6 = Math.sqrt(6);
    /** Times of the stages: the zeros of d<sup>2</sup>/dx<sup>2</sup> x<sup>2</sup>(x - 1)<sup>3</sup>. */
    private static final double[] C = {(4 - S6) / 10, (4 + S6) / 10, 1};

    private static final double R3 = StrictMath.cbrt(3);
    private static final double R9 = StrictMath.cbrt(9);
    static final double MU = 3 + R9 - R3;
    static final double MU_RE = 3 + (R3 - R9) / 2;
    static final double MU_IM = -(Math.sqrt(3) * R3 + 3 * StrictMath.cbrt(Math.sqrt(3))) / 2;
    static final double MU_SQUARE = MU_RE * MU_RE + MU_IM * MU_IM;

    private static final double[][] T = {
        {0.09443876248897524, -0.14125529502095421, 0.03002919410514742},
        {0.25021312296533332, 0.20412935229379994, -0.38294211275726192},
        {1, 1, 0}};
    private static final double[][] T_INVERSE = {
        {4.17871859155190428, 0.32768282076106237, 0.52337644549944951},
        {-4.17871859155190428, -0.32768282076106237, 0.47662355450055044},
        {0.50287263494578682, -2.57192694985560522, 0.59603920482822492}};


    /**
     * The collocation polynomial: the weight of each stage in the coefficients of u, u<sup>2</sup> and u<sup>3</sup>.
     */
    private static final double[][] POLYNOMIAL = {
        {(13 + 7 * S6) / 3, (-23 - 22 * S6) / 3, (10 + 15 * S6) / 3},
        {(13 - 7 * S6) / 3, (-23 + 22 * S6) / 3, (10 - 15 * S6) / 3},
        {1.0 / 3, -8.0 / 3, 10.0 / 3}};

    private RadauTableau() {
    }

    /** The time of stage k, as a fraction of the sub-step. */
    static double c(int k) {
        return C[k];
    }

    /** y = T x, or y = T<sup>-1</sup> x, for the three stages of every entry. */
    static void transform(boolean inverse, double[][] x, double[][] y) {
        double[][] matrix = inverse ? T_INVERSE : T;
        for (int i = 0; i < x[0].length; i++) {
            for (int k = 0; k < 3; k++) {
                y[k][i] = matrix[k][0] * x[0][i] + matrix[k][1] * x[1][i] + matrix[k][2] * x[2][i];
            }
        }
    }

    /** The coefficient of u<sup>power</sup> of the collocation polynomial, power = 1, 2 or 3, for one entry. */
    static double polynomial(int power, double[][] z, int i) {
        return POLYNOMIAL[0][power - 1] * z[0][i] + POLYNOMIAL[1][power - 1] * z[1][i]
                + POLYNOMIAL[2][power - 1] * z[2][i];
    }
}
