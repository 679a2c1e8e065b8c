package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The style of a solver in all charts. The hue shows its family; lightness, dashes and shape show the solver, so that
 * the members of a family differ in grey print too. A series belongs to a solver if its name begins with the solver's,
 * such as "rk4" or "rk4, deltaT = 0.1 s".
 */
public record SolverStyle(SolverFamily family, Color colour, Stroke stroke, Shape shape) {
    /** Name, family, colour, and the number of its dashes and of its shape. */
    private static final String TABLE = """
            euler | EXPLICIT | d55e00 | 0
            midpoint | EXPLICIT | e69f00 | 1
            rk4 | EXPLICIT | 6b2500 | 4
            adams | EXPLICIT | 000000 | 3
            step-doubling | ADAPTIVE | 56b4e9 | 1
            dormand-prince | ADAPTIVE | 0072b2 | 0
            bulirsch-stoer | ADAPTIVE | 0b2f5c | 2
            symplectic-euler | SYMPLECTIC | 5fcfa4 | 1
            verlet | SYMPLECTIC | 009e73 | 0
            yoshida4 | SYMPLECTIC | 00513b | 2
            backward-euler | IMPLICIT | cc79a7 | 1
            linearised-euler | IMPLICIT | e0a8ca | 2
            implicit-midpoint | IMPLICIT | 9b3f86 | 0
            radau | IMPLICIT | 4b1250 | 3
            """;
    private static final Map<String, SolverStyle> LOOKS = TABLE.lines().map(line -> line.split(" [|] ")).collect(
            Collectors.toMap(cells -> cells[0], cells -> style(SolverFamily.valueOf(cells[1]),
            Color.decode("#" + cells[2]), Integer.parseInt(cells[3]))));

    private static SolverStyle style(SolverFamily family, Color colour, int member) {
        return new SolverStyle(family, colour, ChartStyle.stroke(member), ChartStyle.shape(member));
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
        return style(SolverFamily.OWN, colour, k);
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
