package particles.experiments.phase;

import java.util.Locale;

/** A direction of space, by which one component of a particle's motion is chosen. */
public enum Axis {
    /** To the right. */
    X,
    /** Up. */
    Y,
    /** Towards the viewer of the default camera. */
    Z;

    /** @return x, y or z */
    public String symbol() {
        return name().toLowerCase(Locale.ROOT);
    }
}
