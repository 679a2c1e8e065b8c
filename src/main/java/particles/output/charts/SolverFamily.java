package particles.output.charts;

import java.util.Locale;

/** The families of solvers in charts: each has its own hue, and its own panel if there are many solvers. */
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

    /** @return a word for it, in names of files */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** @return the title of its panel */
    public String title() {
        return title;
    }
}
