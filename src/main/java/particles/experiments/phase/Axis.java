package particles.experiments.phase;

import java.util.List;
import java.util.Locale;

/** The axis of a phase portrait: one component of a particle's motion, or its angle about another particle. */
public enum Axis {
    /** To the right. */
    X,
    /** Up. */
    Y,
    /** Towards the viewer of the default camera. */
    Z,
    /**
     * The angle theta about another particle, in the plane of x and y: 0 straight below it, and growing
     * counter-clockwise, also beyond pi.
     */
    ANGLE;

    /** The directions of space. */
    static final List<Axis> DIRECTIONS = List.of(X, Y, Z);

    /** @return x, y, z or angle */
    public String symbol() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** @return the label of the horizontal axis, such as "position x of 'bob' (m)"; the middle may be empty */
    String positionLabel(String whose) {
        return this == ANGLE ? "angle theta" + whose + " (rad)" : "position " + symbol() + whose + " (m)";
    }

    /** @return the label of the vertical axis, such as "velocity vx of 'bob' (m/s)"; the middle may be empty */
    String velocityLabel(String whose) {
        return this == ANGLE ? "angular velocity omega" + whose + " (rad/s)"
                : "velocity v" + symbol() + whose + " (m/s)";
    }
}
