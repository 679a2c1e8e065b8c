package particles.output.charts;

import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.util.Map;
import java.util.Optional;

/**
 * How a solver looks in every chart: the colour says its family, dashes and shape which one it is. A series is a
 * solver's if its name begins with the solver's, as "rk4" or "rk4, deltaT = 0.1 s".
 */
public record SolverStyle(Color colour, Stroke stroke, Shape shape) {
    private static final Map<String, SolverStyle> LOOKS = Map.ofEntries(
            look("euler", 2, 0, 0),                     // the slides' three differ most: they are compared most
            look("midpoint", 5, 0, 1),
            look("rk4", 0, 0, 2),
            look("step-doubling", 1, 1, 3),
            look("dormand-prince", 1, 0, 0),
            look("bulirsch-stoer", 1, 2, 1),
            look("adams", 6, 0, 4),
            look("symplectic-euler", 3, 1, 1),
            look("verlet", 3, 0, 0),
            look("yoshida4", 3, 2, 2),
            look("backward-euler", 4, 0, 0),
            look("linearised-euler", 4, 3, 4),
            look("implicit-midpoint", 4, 1, 3),
            look("radau", 4, 2, 5));

    private static Map.Entry<String, SolverStyle> look(String name, int colour, int dashes, int shape) {
        return Map.entry(name, new SolverStyle(ChartStyle.colour(colour), ChartStyle.stroke(dashes),
                ChartStyle.shape(shape)));
    }

    /**
     * @param series a series' name
     * @return the look of the solver with whose name it begins, if there is one
     */
    public static Optional<SolverStyle> of(String series) {
        int end = 0;
        while (end < series.length() && (Character.isLetterOrDigit(series.charAt(end)) || series.charAt(end) == '-')) {
            end++;
        }
        return Optional.ofNullable(LOOKS.get(series.substring(0, end)));
    }

    /**
     * @param series a name
     * @return the look of the solver with whose name it begins; grey for a solver of one's own
     */
    public static SolverStyle orGrey(String series) {
        return of(series).orElse(new SolverStyle(ChartStyle.AXIS, ChartStyle.stroke(0), ChartStyle.shape(0)));
    }

    /** @return the colour as 0xRRGGBB */
    public int rgb() {
        return colour.getRGB() & 0xffffff;
    }
}
