package particles.app.run;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.StridedRecorder;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * The box in which a run takes place: from the lowest to the highest coordinates that any particle had after any step.
 */
final class Extent extends StridedRecorder {
    private final List<DoubleSummaryStatistics> axes = Stream.generate(DoubleSummaryStatistics::new).limit(3).toList();

    @Override
    protected void record(ParticleSystem system, double[] state, double time) {
        for (int i = 0, x = 0; i < system.getParticles().count(); i++, x += Particles.STRIDE) {
            for (int c = 0; c < 3; c++) {
                axes.get(c).accept(state[x + c]);
            }
        }
    }

    /** @return the corner with the lowest coordinates (m); infinite before a run */
    Vector3 low() {
        return corner(DoubleSummaryStatistics::getMin);
    }

    /** @return the corner with the highest coordinates (m) */
    Vector3 high() {
        return corner(DoubleSummaryStatistics::getMax);
    }

    private Vector3 corner(ToDoubleFunction<DoubleSummaryStatistics> end) {
        return Vector3.at(axes.stream().mapToDouble(end).toArray(), 0);
    }
}
