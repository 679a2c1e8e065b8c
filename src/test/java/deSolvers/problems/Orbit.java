package deSolvers.problems;

/** What tests ask of a {@link Kepler} orbit. */
public final class Orbit {
    private Orbit() {
    }

    /** The energy, -1/2 at the start. */
    public static double energy(Kepler orbit) {
        double[] s = orbit.getState();
        return (s[2] * s[2] + s[3] * s[3]) / 2 - 1 / Math.sqrt(s[0] * s[0] + s[1] * s[1]);
    }

    /** The square of the distance from the exact position. */
    public static double squaredError(Kepler orbit) {
        double[] s = orbit.getState();
        double[] exact = orbit.exactState(orbit.getTime());
        double dx = s[0] - exact[0];
        double dy = s[1] - exact[1];
        return dx * dx + dy * dy;
    }
}
