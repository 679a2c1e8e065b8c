package particles.output.charts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jfree.chart.renderer.xy.XYItemRenderer;
import org.junit.jupiter.api.Test;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

class SolverStyleTest {

    private static SolverStyle look(String name) {
        return SolverStyle.of(name).orElseThrow(() -> new AssertionError("no look for " + name));
    }

    @Test
    void everySolverHasALookOfItsOwnInLinesAndInPoints() {
        Set<List<Object>> lines = new HashSet<>();
        Set<List<Object>> points = new HashSet<>();
        for (String name : SolverCatalog.names()) {
            SolverStyle look = look(name);
            assertTrue(lines.add(List.of(look.colour(), look.stroke())), name);
            assertTrue(points.add(List.of(look.colour(), look.shape())), name);
        }
    }

    @Test
    void aSeriesNameBeginsWithTheWholeNameOfItsSolver() {
        assertEquals(look("rk4"), look("rk4, deltaT = 0.1 s"));
        assertNotEquals(look("euler"), look("symplectic-euler"));
        for (String other : new String[] {"rk45", "eulerian", "kinetic energy", "", "-rk4", "my.own.Solver"}) {
            assertFalse(SolverStyle.of(other).isPresent(), other);
        }
    }

    @Test
    void aSolverLooksTheSameWhereverItStandsAndWhatIsNoneIsGreyBesideIt() {
        Series line = new Series("order 4", Mark.LINE, new double[] {1, 2}, new double[] {1, 2});
        Series rk4 = new Series("rk4", Mark.LINE_AND_POINTS, new double[] {1, 2}, new double[] {1, 3});
        Series verlet = new Series("verlet (damped)", Mark.LINE, new double[] {1, 2}, new double[] {1, 4});
        XYItemRenderer renderer = Charts.of(new ChartData("", "", "", false, false, List.of(line, rk4, verlet)))
                .getXYPlot()
                .getRenderer();
        assertEquals(ChartStyle.AXIS, renderer.getSeriesPaint(0));
        assertEquals(look("rk4").colour(), renderer.getSeriesPaint(1));
        assertEquals(look("rk4").shape(), renderer.getSeriesShape(1));
        assertEquals(look("verlet").colour(), renderer.getSeriesPaint(2));
        assertEquals(look("verlet").stroke(), renderer.getSeriesStroke(2));
        XYItemRenderer alone = Charts.of(new ChartData("", "", "", false, false, List.of(line))).getXYPlot()
                .getRenderer();
        assertEquals(ChartStyle.colour(0), alone.getSeriesPaint(0));
    }
}
