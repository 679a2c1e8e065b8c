package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The style of a solver in all charts. The hue shows its family; lightness, dashes and shape show the solver, so that
 * the members of a family differ in grey print too. A series belongs to a solver if its name begins with the solver's,
 * such as "rk4" or "rk4, deltaT = 0.1 s".
 */
public record SolverStyle(SolverFamily family, Color colour, Stroke stroke, Shape shape) {
    private static final Map<String, SolverStyle> LOOKS = Map.ofEntries(
            look("euler", SolverFamily.EXPLICIT, 0xd55e00, 0),
            look("midpoint", SolverFamily.EXPLICIT, 0xe69f00, 1),
            look("rk4", SolverFamily.EXPLICIT, 0x6b2500, 4),
            look("adams", SolverFamily.EXPLICIT, 0x000000, 3),
            look("step-doubling", SolverFamily.ADAPTIVE, 0x56b4e9, 1),
            look("dormand-prince", SolverFamily.ADAPTIVE, 0x0072b2, 0),
            look("bulirsch-stoer", SolverFamily.ADAPTIVE, 0x0b2f5c, 2),
            look("symplectic-euler", SolverFamily.SYMPLECTIC, 0x5fcfa4, 1),
            look("verlet", SolverFamily.SYMPLECTIC, 0x009e73, 0),
            look("yoshida4", SolverFamily.SYMPLECTIC, 0x00513b, 2),
            look("backward-euler", SolverFamily.IMPLICIT, 0xcc79a7, 1),
            look("linearised-euler", SolverFamily.IMPLICIT, 0xe0a8ca, 2),
            look("implicit-midpoint", SolverFamily.IMPLICIT, 0x9b3f86, 0),
            look("radau", SolverFamily.IMPLICIT, 0x4b1250, 3));

    private static Map.Entry<String, SolverStyle> look(String name, SolverFamily family, int rgb, int member) {
        return Map.entry(name, new SolverStyle(family, new Color(rgb), ChartStyle.stroke(member),
                ChartStyle.shape(member)));
    }

    /**
     * @param series a series' name
     * @return the style of the solver with whose name it begins, if there is one
     */
    public static Optional<SolverStyle> of(String series) {
        return Optional.ofNullable(LOOKS.get(series.split("[^\\p{L}\\p{Nd}-]", 2)[0]));
    }

    /**
     * @param series a name
     * @return the style of the solver with whose name it begins; grey for a solver of one's own
     */
    public static SolverStyle orGrey(String series) {
        return of(series).orElse(own(ChartStyle.AXIS, 0));
    }

    /** @return the k-th style without a solver, in this colour */
    static SolverStyle own(Color colour, int k) {
        return new SolverStyle(SolverFamily.OWN, colour, ChartStyle.stroke(k), ChartStyle.shape(k));
    }

    /** @return whether its line is broken */
    boolean hasDashes() {
        return ((BasicStroke) stroke).getDashArray() != null;
    }

    /** @return the colour as 0xRRGGBB */
    public int rgb() {
        return colour.getRGB() & 0xffffff;
    }

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

        /** The title of its panel. */
        public final String title;

        SolverFamily(String title) {
            this.title = title;
        }

        /** @return a word for it, in names of files */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }
}
