package particles.experiments.phase;

import java.util.List;
import java.util.Locale;
import particles.view.Axis;

/** The coordinate of a phase portrait: one component of a particle's motion, or its angle about another particle. */
public enum Coordinate {
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
    static final List<Coordinate> DIRECTIONS = List.of(X, Y, Z);

    /** @return x, y, z or angle */
    public String symbol() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** @return the horizontal axis, such as "position x of 'bob' (m)"; the middle may be empty */
    Axis position(String whose) {
        return this == ANGLE ? Axis.linear("angle theta" + whose, "rad")
                : Axis.linear("position " + symbol() + whose, "m");
    }

    /** @return the vertical axis, such as "velocity vx of 'bob' (m/s)"; the middle may be empty */
    Axis velocity(String whose) {
        return this == ANGLE ? Axis.linear("angular velocity omega" + whose, "rad/s")
                : Axis.linear("velocity v" + symbol() + whose, "m/s");
    }
}
