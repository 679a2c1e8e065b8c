package benchmarks;

import particles.ParticleSystem;
import particles.Systems;
import particles.law.Particles;
import particles.view.SpringView;

/**
 * A method written out by hand for one workload, with plain arrays and loops: no interfaces, no checks, no particle
 * system. A step of ours is measured against it.
 */
final class ByHand implements Method {
    static final String SUFFIX = " by hand";

    private final String name;
    private final double duration;
    private final int steps;
    private final double h;
    private final int d;                                // positions in a block of the state
    private final double[] s;
    private final double[] k;
    private final double[] trial;
    private final double[] next;
    private final double[] weights;                     // m g, upwards
    private final double[] inverseMasses;
    private final int[] from;
    private final int[] to;
    private final double[] stiffness;
    private final double[] restLengths;

    ByHand(String name, Workload workload, double duration, int steps) {
        this.name = name;
        this.duration = duration;
        this.steps = steps;
        h = duration / steps;
        s = workload.start().getPrimaryState().clone();
        k = s.clone();
        trial = s.clone();
        next = s.clone();
        if (!(workload.source() instanceof ParticleSystem system)) {
            d = 1;
            weights = inverseMasses = stiffness = restLengths = new double[0];
            from = to = new int[0];
            return;
        }
        d = 3;
        Particles particles = system.getParticles();
        inverseMasses = particles.getInverseMasses().clone();
        weights = particles.getMasses().clone();
        for (int i = 0; i < weights.length; i++) {
            weights[i] *= Systems.GRAVITY.y();
        }
        SpringView springs = (SpringView) system.getEffects().get(1);
        from = new int[springs.springCount()];
        to = new int[from.length];
        stiffness = new double[from.length];
        restLengths = new double[from.length];
        for (int q = 0; q < from.length; q++) {
            from[q] = Particles.STRIDE * springs.from(q);
            to[q] = Particles.STRIDE * springs.to(q);
            stiffness[q] = springs.stiffness(q);
            restLengths[q] = springs.restLength(q);
        }
    }

    @Override
    public void solve(Workload workload) {
        System.arraycopy(workload.start().getPrimaryState(), 0, s, 0, s.length);
        for (int n = 0; n < steps; n++) {
            switch (name.charAt(0)) {
                case 'r' -> rk4();
                case 'm' -> midpoint();
                case 'e' -> euler();
                default -> symplecticEuler();
            }
        }
        workload.end(duration, s);
    }

    private void rk4() {
        System.arraycopy(s, 0, next, 0, s.length);
        derivative(s);
        stage(h / 6, h / 2);
        derivative(trial);
        stage(h / 3, h / 2);
        derivative(trial);
        stage(h / 3, h);
        derivative(trial);
        stage(h / 6, 0);
        System.arraycopy(next, 0, s, 0, s.length);
    }

    private void stage(double part, double ahead) {
        for (int i = 0; i < s.length; i++) {
            next[i] += part * k[i];
            trial[i] = s[i] + ahead * k[i];
        }
    }

    private void midpoint() {
        derivative(s);
        for (int i = 0; i < s.length; i++) {
            trial[i] = s[i] + h / 2 * k[i];
        }
        derivative(trial);
        step();
    }

    private void euler() {
        derivative(s);
        step();
    }

    private void step() {
        for (int i = 0; i < s.length; i++) {
            s[i] += h * k[i];
        }
    }

    private void symplecticEuler() {
        derivative(s);
        for (int x = 0; x < s.length; x += 2 * d) {
            for (int c = x; c < x + d; c++) {
                s[c + d] += h * k[c + d];
                s[c] += h * s[c + d];
            }
        }
    }

    private void derivative(double[] s) {
        if (d == 1) {
            k[0] = s[1];
            k[1] = -s[0];
            return;
        }
        for (int x = 0, i = 0; x < s.length; x += Particles.STRIDE, i++) {
            k[x] = s[x + 3];
            k[x + 1] = s[x + 4];
            k[x + 2] = s[x + 5];
            k[x + 3] = 0;
            k[x + 4] = weights[i];
            k[x + 5] = 0;
        }
        for (int q = 0; q < from.length; q++) {
            int i = from[q];
            int j = to[q];
            double x = s[j] - s[i];
            double y = s[j + 1] - s[i + 1];
            double z = s[j + 2] - s[i + 2];
            double length = Math.sqrt(x * x + y * y + z * z);
            double pull = stiffness[q] * (length - restLengths[q]) / length;
            k[i + 3] += pull * x;
            k[i + 4] += pull * y;
            k[i + 5] += pull * z;
            k[j + 3] -= pull * x;
            k[j + 4] -= pull * y;
            k[j + 5] -= pull * z;
        }
        for (int v = 3, i = 0; v < s.length; v += Particles.STRIDE, i++) {
            k[v] *= inverseMasses[i];
            k[v + 1] *= inverseMasses[i];
            k[v + 2] *= inverseMasses[i];
        }
    }
}
