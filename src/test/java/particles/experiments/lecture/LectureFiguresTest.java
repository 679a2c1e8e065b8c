package particles.experiments.lecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.lecture.LectureFigures.Figure;
import particles.experiments.lecture.LectureFigures.Result;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Series;
import particles.view.VectorField;

class LectureFiguresTest {
    private static final List<Result> RESULTS = LectureFigures.ON_SLIDES.stream().map(LectureFigures::run).toList();

    /**
     * The values are the stability functions', to six digits; measured and theory differ by rounding, 8e-12 at most.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            euler, 0.11737, 161, 3.008304, 9.049891,  -0.086061, 161
            midpoint, 1,   11,   3.411969, 11.641532, 1.178636,  22
            midpoint, 0.5, 100,  2.171047, 4.713443,  1.914611,  200
            midpoint, 0.1, 5000, 1.064494, 1.133147,  0.830824,  10000
            rk4,      1,   8,    0.952268, 0.906814,  -0.044631, 32
            rk4,      1,   100,  0.542612, 0.294427,  -0.557889, 400
            rk4,      0.4, 1250, 0.965755, 0.932682,  -0.100637, 5000
            """)
    void figuresHaveTheNumbersOfTheory(String solver, double deltaT, int steps, double amplitude, double energy,
            double phase, long evaluations) {
        Figure figure = new Figure(solver, deltaT, steps);
        assertTrue(LectureFigures.ON_SLIDES.contains(figure), "it is one of the slides' figures");
        Result result = LectureFigures.run(figure);
        assertEquals(amplitude, result.amplitude(), 0.5e-6);
        assertEquals(energy, result.amplitude() * result.amplitude(), 0.5e-6);
        assertEquals(phase, result.phaseError(), 0.5e-6);
        assertEquals(evaluations, result.evaluations());
    }

    /**
     * The table has measured values and theory side by side; as people are shown them, to six digits or more, they are
     * equal.
     */
    @Test
    void tableHasEveryFigureOfTheSlidesBesideTheory() {
        DataTable table = LectureFigures.table(RESULTS);
        assertEquals(7, table.rows().size());
        for (List<Object> row : table.rows()) {
            for (int c = 4; c < 10; c += 2) {
                assertEquals((Double) row.get(c + 1), (Double) row.get(c), 5e-11,
                        table.columns().get(c).name());   // measured 7.7e-12
                assertTrue(table.columns().get(c).digits() >= 6);
            }
        }
    }

    /** The angle between both ends is the phase error, clockwise where it is positive. */
    @ParameterizedTest
    @CsvSource({"midpoint, 1, 11, 1.178636", "rk4, 0.4, 1250, -0.100637"})
    void bothEndsAreMarked(String solver, double deltaT, int steps, double phase) {
        Chart chart = LectureFigures.chart(LectureFigures.run(new Figure(solver, deltaT, steps)));
        Series end = chart.series().get(3);
        Series exactEnd = chart.series().get(4);
        assertEquals(List.of("end", "exact end"), List.of(end.name(), exactEnd.name()));
        double angle = Math.atan2(exactEnd.y()[0], exactEnd.x()[0]) - Math.atan2(end.y()[0], end.x()[0]);
        assertEquals(phase, Math.IEEEremainder(angle, 2 * Math.PI), 0.5e-6);
    }

    @Test
    void chartsShowEveryStateAndTheExactCircle() {
        Result result = LectureFigures.run(new Figure("midpoint", 0.1, 5000));
        Chart chart = LectureFigures.chart(result);
        assertEquals(5001, chart.series().get(0).x().length);
        assertEquals(Look.of(SolverCatalog.info("midpoint")), chart.series().get(0).look());
        double reach = LectureFigures.reach(result);
        VectorField field = LectureFigures.field(reach);
        for (int k = 0; k < field.dv().length; k++) {
            assertEquals(-field.x(k), field.dv()[k]);
        }
        for (double x : result.x()) {
            assertTrue(Math.abs(x) < reach);
        }
    }
}
