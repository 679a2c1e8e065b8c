package particles.experiments.work;

import java.util.Arrays;
import particles.effects.springs.SpringForce;
import particles.law.Particles;
import particles.view.SpringView;

/** A mass-spring system as a plain loop over its springs, without effects, reactions or any choice at all. */
final class SpringLoop {
    private SpringLoop() {
    }

    /** ds/dt by the law of {@link particles.effects.springs.SpringForce}. */
    static void derivative(SpringView springs, double[] inverseMasses, double[] s, double[] dSdt) {
        Arrays.fill(dSdt, 0);
        for (int k = 0; k < springs.springCount(); k++) {
            int i = Particles.STRIDE * springs.from(k);
            int j = Particles.STRIDE * springs.to(k);
            double x = s[j] - s[i];
            double y = s[j + 1] - s[i + 1];
            double z = s[j + 2] - s[i + 2];
            double length = Math.sqrt(x * x + y * y + z * z);
            double stretching = (x * (s[j + 3] - s[i + 3]) + y * (s[j + 4] - s[i + 4]) + z * (s[j + 5] - s[i + 5]))
                    / length;
            double perLength = (springs.stiffness(k) * (length - springs.restLength(k))
                    + springs.damping(k) * stretching) / length;
            dSdt[i + 3] += perLength * x;
            dSdt[i + 4] += perLength * y;
            dSdt[i + 5] += perLength * z;
            dSdt[j + 3] -= perLength * x;
            dSdt[j + 4] -= perLength * y;
            dSdt[j + 5] -= perLength * z;
        }
        for (int k = 0; k < s.length; k += Particles.STRIDE) {
            for (int c = k; c < k + 3; c++) {
                dSdt[c] = s[c + 3];
                dSdt[c + 3] *= inverseMasses[k / Particles.STRIDE];
            }
        }
    }
}
