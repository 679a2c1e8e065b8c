package particles.teaching.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.teaching.solvers.PlantedSolvers.blocks;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.solver;
import static particles.teaching.solvers.PlantedSolvers.state;
import static particles.teaching.solvers.PlantedSolvers.with;

import deSolvers.DESolver;
import deSolvers.SecondOrderStateSource;
import deSolvers.adaptive.DormandPrinceSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.PlantedSolvers.AdamsBashforth2;
import particles.view.Chart;
import particles.view.Series;

/** Stability of solvers that nobody told us about, from their steps, against closed forms. */
class StabilityFiguresTest {

    /**
     * The theta method for linear laws, as a student might write it: (1 - theta deltaT M) s' = s + (1 - theta) deltaT
     * dSdt.
     */
    static DESolver theta(double theta) {
        return solver((source, deltaT) -> {
            double[] start = state(source);
            double[] dSdt = slope(source);
            int n = start.length;
            source.incTime(deltaT);
            double[] none = PlantedSolvers.slopeAt(source, new double[n]);
            DMatrixRMaj left = CommonOps_DDRM.identity(n);
            DMatrixRMaj right = new DMatrixRMaj(n, 1);
            for (int j = 0; j < n; j++) {
                double[] unit = new double[n];
                unit[j] = 1;
                double[] column = PlantedSolvers.slopeAt(source, unit);
                for (int i = 0; i < n; i++) {
                    left.add(i, j, -theta * deltaT * (column[i] - none[i]));
                }
                right.set(j, 0, start[j] + deltaT * ((1 - theta) * dSdt[j] + theta * none[j]));
            }
            DMatrixRMaj end = new DMatrixRMaj(n, 1);
            CommonOps_DDRM.solve(left, right, end);
            source.setState(end.getData());
        });
    }

    private static StabilityFigures figures(Supplier<DESolver> maker) {
        return StabilityFigures.of("mine", maker, false);
    }

    private static String value(StabilityFigures figures, String property) {
        return figures.rows().stream().filter(row -> row.get(0).toString().startsWith(property)).findFirst()
                .orElseThrow()
                .get(1).toString();
    }

    private static double damping(StabilityFigures figures) {
        return Double.parseDouble(value(figures, "real limit"));
    }

    private static Series series(Chart chart, String name) {
        return chart.series().stream().filter(series -> series.name().equals(name)).findFirst().orElseThrow();
    }

    /**
     * The region's outline is a circle around a point of the real axis, and where the stripes are is the other side of
     * it.
     */
    private static void assertCircle(StabilityFigures figures, double centre, double radius, boolean stableInside) {
        Chart chart = figures.region().orElseThrow().charts().get(0);
        double[] outline = off(series(chart, "mine"), centre, radius);
        // measured 2.4e-4: an edge of the net is a fifteenth of the radius or less and is halved eight times
        assertEquals(0, Arrays.stream(outline).map(Math::abs).max().orElseThrow(), 1e-3 * radius);
        assertTrue(outline.length > 100, "points " + outline.length);       // measured 126 and more
        double[] stripes = off(series(chart, "stable"), centre, radius);
        // measured 7.4e-4: they end on the straight pieces of the outline, from edge to edge
        assertEquals(0, Math.max(0, Arrays.stream(stripes).map(off -> stableInside ? off : -off).max().orElseThrow()),
                1e-3 * radius);
        assertTrue(stripes.length > 40, "ends of stripes " + stripes.length);
    }

    /** How far the points of a series are outside a circle around a point of the real axis. */
    private static double[] off(Series series, double centre, double radius) {
        return IntStream.range(0, series.x().length).mapToDouble(k -> Math.hypot(series.x()[k] - centre,
                series.y()[k]) - radius).filter(off -> !Double.isNaN(off)).toArray();
    }

    /**
     * |1 + (1 - theta) z| = |1 - theta z| is the circle of radius 1/|1 - 2 theta| that touches 0:
     * stable inside for theta below 1/2.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            0, -1, true
            0.4, -5, true
            0.25, -2, true
            0.75, 2, false
            1, 1, false
            """)
    void aStudentsThetaMethodHasItsCircle(double theta, double centre, boolean inside) {
        StabilityFigures figures = figures(() -> theta(theta));
        assertCircle(figures, centre, Math.abs(centre), inside);
        if (inside) {
            assertEquals(2 * Math.abs(centre), damping(figures), 5e-8 * Math.abs(centre));
        } else {
            assertEquals("unbounded", value(figures, "real limit"));
            assertEquals("unbounded", value(figures, "imaginary limit"));
        }
    }

    @Test
    void theTrapezoidalRuleIsStableOnTheWholeAxis() {
        StabilityFigures figures = figures(() -> theta(0.5));
        assertEquals("unbounded", value(figures, "real limit"));
        assertEquals("unbounded", value(figures, "imaginary limit"));
    }

    /**
     * Whether it takes any source, of which its rotation is none, or refuses, in its own words, one whose velocities it
     * cannot know. q = 4 is the end without damping.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatStepsPositionsAndVelocitiesApartIsTriedOnSprings(boolean refuses) {
        StabilityFigures figures = figures(() -> solver((source, deltaT) -> {
            if (refuses && !(source instanceof SecondOrderStateSource)) {
                throw new IllegalStateException("which are the velocities?");
            }
            blocks().stepState(source, deltaT);
        }));
        assertEquals(2, Double.parseDouble(value(figures, "imaginary limit")), 5e-8);
        // critically damped: 4 - h^2 - 4 h = 0
        assertEquals(2 * Math.sqrt(2) - 2, Double.parseDouble(value(figures, "damped limit")), 5e-8);
        Chart region = figures.region().orElseThrow().charts().get(0);
        // x'' = -q x - g x' of symplectic Euler: the new trace is 2 - q - g, the determinant 1 - g, and -1 is reached
        // at 4 = q + 2 g, where q = |z|^2 and g = -2 Re z
        Series outline = series(region, "mine");
        int[] inside = IntStream.range(0, outline.x().length).filter(k -> outline.x()[k] < -0.05).toArray();
        for (int k : inside) {
            // a square of the net, halved eight times
            assertEquals(Math.sqrt(8), Math.hypot(outline.x()[k] - 2, outline.y()[k]), 1e-3);
        }
        assertTrue(inside.length > 50, "points " + inside.length);
    }

    /**
     * The boundary of Adams-Bashforth 2 is z = 2 (w^2 - w)/(3 w - 1), |w| = 1: -1 at w = -1,
     * and nothing of the imaginary axis.
     */
    @Test
    void aMultistepMethodIsMeasuredOverManySteps() {
        StabilityFigures figures = StabilityFigures.of("mine", AdamsBashforth2::new, true);
        assertEquals(1, damping(figures), 5e-3);        // two roots of size 1 beat where they meet: measured 1.0016
        assertEquals("0", value(figures, "imaginary limit"));
        assertTrue(figures.rows().get(0).get(2).toString().endsWith("from the growth over many steps"));
        assertTrue(figures.region().isPresent());
    }

    /**
     * Adams-Bashforth 2 as the predictor of the trapezoidal rule: one root is 1 at z = -2, where the region has a tip.
     */
    @Test
    void theOutlineOnACoarseGridEndsAtTheLimitsAndTheAreaIsClosed() {
        StabilityFigures figures = StabilityFigures.of("mine", () -> {
            List<double[]> kept = new ArrayList<>();
            return solver((source, deltaT) -> {
                double[] s = state(source);
                kept.add(slope(source));
                double[] f = kept.get(kept.size() - 1);
                double[] before = kept.get(Math.max(0, kept.size() - 2));
                source.incTime(deltaT);
                double[] g = PlantedSolvers.slopeAt(source, with(s, i -> deltaT * (1.5 * f[i] - 0.5 * before[i])));
                source.setState(with(s, i -> deltaT / 2 * (f[i] + g[i])));
            });
        }, true);
        assertEquals(2, damping(figures), 1e-4);
        Chart region = figures.region().orElseThrow().charts().get(0);
        double[] x = series(region, "mine").x();
        double[] y = series(region, "mine").y();
        // a square of the net is 0.11, halved eight times
        assertEquals(-damping(figures), Arrays.stream(x).filter(at -> !Double.isNaN(at)).min().orElseThrow(), 1e-3);
        double above = IntStream.range(1, x.length).filter(k -> x[k - 1] * x[k] <= 0 && x[k - 1] != x[k])
                .mapToDouble(k -> y[k] - x[k] * (y[k] - y[k - 1]) / (x[k] - x[k - 1])).max().orElseThrow();
        assertEquals(Double.parseDouble(value(figures, "imaginary limit")), above, 0.01);
        Series area = series(region, "stable");
        assertEquals(above, Arrays.stream(area.y()).filter(at -> !Double.isNaN(at)).max().orElseThrow(), 0.1);
        int first = 0;
        for (int k = 0; k < area.x().length; k++) {
            if (Double.isNaN(area.x()[k])) {
                assertEquals(area.x()[first], area.x()[k - 1]);
                assertEquals(area.y()[first], area.y()[k - 1]);
                first = k + 1;
            }
        }
    }

    /** A point of the grid takes up to 600 steps. */
    @Test
    void theGridOfADearMethodIsCoarser() {
        AtomicLong evaluations = new AtomicLong();
        StabilityFigures figures = StabilityFigures.of("mine", () -> {
            DESolver solver = new AdamsBashforth2();
            return solver((source, deltaT) -> {
                evaluations.incrementAndGet();
                solver.stepState(source, deltaT);
            });
        }, true);
        assertTrue(figures.region().isPresent());
        assertTrue(evaluations.get() < 2.5e6, evaluations + " evaluations");
    }

    @Test
    void whatHasNoFunctionSaysWhy() {
        Random random = new Random(1);
        StabilityFigures shaky = figures(() -> PlantedSolvers.euler((dSdt, deltaT) -> dSdt * deltaT * (1
                + 0.1 * random.nextDouble())));
        assertHas(shaky.rows().get(0).toString(), "a matrix that depends on deltaT lambda alone");
        StabilityFigures adaptive = figures(DormandPrinceSolver::new);
        assertHas(adaptive.rows().get(0).toString(), "one step follows two whole revolutions");
        StabilityFigures fixed = figures(() -> PlantedSolvers.euler((dSdt, deltaT) -> dSdt * 0.1));
        assertHas(fixed.rows().get(0).toString(), "a matrix that depends on deltaT lambda alone");
        for (StabilityFigures none : List.of(shaky, adaptive, fixed)) {
            assertFalse(none.region().isPresent());
        }
    }
}
