package particles;

import java.util.ArrayList;
import java.util.List;

/** The fixed particles that follow a given motion. */
final class Anchors {
    private static final int STRIDE = Particles.STRIDE;

    private final List<Anchor> anchors = new ArrayList<>();
    private final double[] values = new double[9];

    private record Anchor(int number, int particle, AnchorMotion motion) {
    }

    /** Adds one and puts it where its motion begins. */
    void add(int particle, AnchorMotion motion, double[] state, double time) {
        anchors.add(new Anchor(anchors.size(), particle, motion));
        motion.at(time, values);
        System.arraycopy(values, 0, state, STRIDE * particle, STRIDE);
    }

    /** Puts the given accelerations into a derivative. */
    void accelerate(double time, double[] dSdt) {
        for (int a = 0; a < anchors.size(); a++) {
            anchors.get(a).motion().at(time, values);
            System.arraycopy(values, STRIDE, dSdt, STRIDE * anchors.get(a).particle() + 3, 3);
        }
    }

    void reindex(int[] newIndex) {
        anchors.removeIf(anchor -> newIndex[anchor.particle()] < 0);
        anchors.replaceAll(anchor -> new Anchor(anchor.number(), newIndex[anchor.particle()], anchor.motion()));
    }

    /** The motions follow from the scene; which of them are left, and where their particles are by now, does not. */
    void remember(Memory memory) {
        int left = memory.keep(anchors.size());
        List<Anchor> before = List.copyOf(anchors);
        anchors.clear();
        for (int a = 0; a < left; a++) {
            int number = memory.keep(memory.isReading() ? 0 : before.get(a).number());
            int particle = memory.keep(memory.isReading() ? 0 : before.get(a).particle());
            AnchorMotion motion = before.get(memory.isReading() ? number : a).motion();
            anchors.add(new Anchor(number, particle, motion));
        }
    }

    /** The indices of the particles. */
    int[] particles() {
        return anchors.stream().mapToInt(Anchor::particle).toArray();
    }
}
