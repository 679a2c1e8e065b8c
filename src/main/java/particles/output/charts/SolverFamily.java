package particles.output.charts;

/** Families of solvers: each has a hue in all charts, and a panel of its own where there are many solvers. */
public enum SolverFamily {
    /** Runge-Kutta and multistep methods with a fixed step. */
    EXPLICIT("explicit, fixed step"),
    /** Explicit methods that choose their sub-steps. */
    ADAPTIVE("explicit, adaptive"),
    /** Methods for positions and velocities. */
    SYMPLECTIC("symplectic"),
    /** Methods that solve equations in each step. */
    IMPLICIT("implicit"),
    /** Solvers of one's own. */
    OWN("your own");

    private final String title;

    SolverFamily(String title) {
        this.title = title;
    }

    /** @return what stands above its panel */
    public String title() {
        return title;
    }
}
