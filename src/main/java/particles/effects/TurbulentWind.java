package particles.effects;

import java.util.Arrays;
import java.util.List;
import particles.law.Particles;
import particles.law.Require;
import particles.law.SeededRandom;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * Turbulent wind: a steady wind that carries eddies of many sizes, smooth in space and time,
 * <pre>
 *   u(x, t) = mean + sum of a_k e_k cos(k . (x - mean t) - w_k t + phase_k),     e_k perpendicular to k
 * </pre>
 * Each wave is divergence-free. Wavelengths form a geometric sequence from twice the size of the largest eddies down to
 * an eighth of that. Amplitudes are proportional to |k|<sup>-1/3</sup>, which gives Kolmogorov's spectrum for this
 * sequence, and an eddy lives about as long as one turn takes. The same seed gives the same field on every machine.
 *
 * <p>Source: R. Kraichnan, "Diffusion by a random velocity field", Physics of Fluids 13 (1970).
 */
public final class TurbulentWind implements Wind {
    private static final int STRIDE = Particles.STRIDE;
    private static final int WAVES = 24;
    private static final double SMALLEST = 1.0 / 8;

    private final Vector3 mean;
    private final double[] k = new double[3 * WAVES];
    private final double[] amplitude = new double[3 * WAVES];   // a_k e_k
    private final double[] frequency = new double[WAVES];       // w_k + k . mean
    private final double[] phase = new double[WAVES];

    /**
     * @param mean     the steady part (m/s)
     * @param strength the root mean square of the varying part's speed (m/s), 0 or more
     * @param eddySize the size of the largest eddies (m), positive: half their wavelength
     * @param seed     the seed of the random field
     * @throws IllegalArgumentException if a number is out of its range
     */
    public TurbulentWind(Vector3 mean, double strength, double eddySize, long seed) {
        Require.notNegative("the strength of turbulence", strength);
        Require.positive("the size of eddies", eddySize);
        this.mean = mean.requireFinite("wind");
        SeededRandom random = new SeededRandom(seed);
        double squares = 0;
        for (int w = 0; w < WAVES; w++) {
            squares += StrictMath.pow(numberOf(w, eddySize), -2.0 / 3) / 2;
        }
        for (int w = 0; w < WAVES; w++) {
            double number = numberOf(w, eddySize);
            double a = strength / Math.sqrt(squares) * StrictMath.pow(number, -1.0 / 3);
            Vector3 direction = random.nextDirection(new Vector3(0, 1, 0), Math.PI);
            Vector3 along = random.nextDirection(new Vector3(0, 1, 0), Math.PI);
            Vector3 across = along.minus(direction.times(along.dot(direction))).normalized();
            direction.times(number).put(k, 3 * w);
            across.times(a).put(amplitude, 3 * w);
            frequency[w] = a * number + direction.times(number).dot(mean);
            phase[w] = 2 * Math.PI * random.nextDouble();
        }
    }

    private static double numberOf(int wave, double eddySize) {
        return Math.PI / eddySize * StrictMath.pow(1 / SMALLEST, wave / (WAVES - 1.0));
    }

    @Override
    public void getVelocities(double[] state, double time, double[] wind, int from, int to) {
        for (int i = from; i < to; i++) {
            int v = STRIDE * i + 3;
            mean.put(wind, v);
            for (int w = 0; w < WAVES; w++) {
                double wave = StrictMath.cos(angle(w, state, i, time));
                for (int c = 0; c < 3; c++) {
                    wind[v + c] += amplitude[3 * w + c] * wave;
                }
            }
        }
    }

    private double angle(int w, double[] state, int i, double time) {
        int x = STRIDE * i;
        return k[3 * w] * state[x] + k[3 * w + 1] * state[x + 1] + k[3 * w + 2] * state[x + 2] - frequency[w] * time
                + phase[w];
    }

    @Override
    public void getGradient(double[] state, double time, int i, double[] gradient) {
        Arrays.fill(gradient, 0);
        for (int w = 0; w < WAVES; w++) {
            double slope = -StrictMath.sin(angle(w, state, i, time));
            for (int e = 0; e < 9; e++) {
                gradient[e] += slope * amplitude[3 * w + e / 3] * k[3 * w + e % 3];
            }
        }
    }

    /** Turbulence in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Double> STRENGTH = NumberType.notNegative("m/s").required("strength",
                "The root mean square speed of the eddies (m/s).");
        private static final Key<Double> EDDY_SIZE = NumberType.positive("m").withDefault("eddySize", 1.0,
                "The size of the largest eddies (m); the smallest are an eighth of that.");
        private static final Key<Vector3> MEAN = VectorType.of("m/s").withDefault("mean", Vector3.ZERO,
                "The steady wind that carries the eddies along (m/s).");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("turbulence", "Moves the air in eddies of many sizes. Particles feel it only through drag.", STRENGTH,
                    EDDY_SIZE, MEAN, SharedKeys.SEED);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.setWind(new TurbulentWind(values.get(MEAN), values.get(STRENGTH), values.get(EDDY_SIZE),
                    values.get(SharedKeys.SEED)));
            scene.noteSpeed(values.get(MEAN).length() + values.get(STRENGTH));
        }

        @Override
        public List<String> needs() {
            return List.of("drag", "quadraticDrag");
        }

        @Override
        public List<String> excludes() {
            return List.of("wind");
        }
    }
}
