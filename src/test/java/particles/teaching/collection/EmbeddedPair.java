package particles.teaching.collection;

import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;

/** An embedded pair with sub-steps inside of deltaT, and slips of their control. */
final class EmbeddedPair extends DESolver {
    private final double[][] a;
    private final double[] b;
    private final double[] error;
    private final double[] c;
    private final double tolerance;
    private final double order;
    private final List<String> slips;

    EmbeddedPair(double[][] a, double[] b, double[] others, double[] times, List<String> words) {
        this.a = a;
        this.b = b;
        error = Methods.plus(b, -1, others);
        c = times.length > 0 ? times : Methods.sums(a);
        tolerance = Double.parseDouble(words.get(0));
        order = Double.parseDouble(words.get(1));
        slips = words;
    }

    private double size(double[] off, double[] s) {
        double size = 0;
        for (int i = 0; i < (slips.contains("first-particle") ? 3 : s.length); i++) {
            double signed = slips.contains("no-abs") ? off[i] : Math.abs(off[i]);
            size = Math.max(size, signed / (tolerance * (1 + Math.abs(s[i]))));
        }
        return size;
    }

    @Override
    public void stepState(DEStateSource source, double deltaT) {
        double[] s = state(source);
        double t = source.getTime();
        double end = t + deltaT;
        double h = slips.contains("never-rejects") ? deltaT / 10 : deltaT;
        while (slips.contains("forward-only") ? t < end : (end - t) * deltaT > 0) {
            h = Math.abs(h) > Math.abs(end - t) && !slips.contains("uncut") ? end - t : h;
            double[][] k = new double[a.length][];
            for (int j = 0; j < a.length; j++) {
                double[] trial = Methods.trial(s, h, a[j], k).clone();
                if (slips.contains("loop")) {
                    trial[s.length - 1] = s[s.length - 1];
                }
                Methods.clock(source, slips.contains("clock-at-end") ? end - deltaT : t + c[j] * h);
                k[j] = slopeAt(source, trial);
            }
            double[] off = Methods.trial(new double[s.length], h, error, k);
            double size = size(off, s);
            boolean nan = Double.isNaN(Arrays.stream(off).sum());
            if (nan && !slips.contains("loops-at-NaN")) {
                throw new ArithmeticException("the derivative is NaN");
            }
            boolean good = !nan && (slips.contains("inverted") ? size > 1 : size <= 1)
                    || slips.contains("never-rejects");
            s = good || slips.contains("keeps-rejected") ? Methods.trial(s, h, b, k) : s;
            t = !good && !slips.contains("clock-runs") ? t : h == end - t ? end : t + h;
            h *= Math.max(0.2, Math.min(5, 0.9 * Math.pow(Math.max(size, 1e-10), -1 / order)));
        }
        source.setState(s);
        Methods.clock(source, slips.contains("uncut") ? t : end);
    }
}
