package particles.effects;

import java.util.List;
import particles.law.Require;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * Uniform wind that varies as a sine in time,
 * <pre>
 *   u(t) = mean + gust sin(2 pi t / period)
 * </pre>
 * With gust 0 it is steady. The slides: "In mass-spring systems, often no t dependence but might have e.g. time-varying
 * wind field."
 */
public final class GustyWind implements Wind {
    private final Vector3 mean;
    private final Vector3 gust;
    private final double period;

    /**
     * @param mean   the steady part (m/s)
     * @param gust   the amplitude of the varying part (m/s)
     * @param period the period of the sine (s), positive
     * @throws IllegalArgumentException if a number is not finite or the period not positive
     */
    public GustyWind(Vector3 mean, Vector3 gust, double period) {
        this.mean = mean.requireFinite("wind");
        this.gust = gust.requireFinite("gust");
        this.period = Require.positive("the period of gusts", period);
    }

    /**
     * @param time t (s)
     * @return the air's velocity, the same everywhere (m/s)
     */
    public Vector3 velocityAt(double time) {
        return mean.plus(gust.times(StrictMath.sin(2 * Math.PI * time / period)));
    }

    @Override
    public double getPeriod() {
        return gust.isZero() ? Double.POSITIVE_INFINITY : period;
    }

    @Override
    public void getVelocities(double[] state, double time, double[] wind, int from, int to) {
        Vector3 u = velocityAt(time);
        for (int v = 6 * from + 3; v < 6 * to; v += 6) {
            u.put(wind, v);
        }
    }

    /** Steady and gusty wind in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Vector3> MEAN = VectorType.of("m/s").required("mean",
                "The steady part of the wind (m/s).");
        private static final Key<Vector3> GUST = VectorType.of("m/s").withDefault("gust", Vector3.ZERO,
                "The amplitude of the gusts (m/s); the wind is mean + gust sin(2 pi t / period).");
        private static final Key<Double> PERIOD = NumberType.positive("s").withDefault("period", 1.0,
                "The period of the gusts (s).");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("wind", "Moves the air. Particles feel it only through drag.", MEAN, GUST, PERIOD);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.setWind(new GustyWind(values.get(MEAN), values.get(GUST), values.get(PERIOD)));
            scene.noteSpeed(values.get(MEAN).length() + values.get(GUST).length());
        }

        @Override
        public List<String> needs() {
            return List.of("drag", "quadraticDrag");
        }
    }
}
