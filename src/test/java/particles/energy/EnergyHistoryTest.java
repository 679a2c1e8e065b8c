package particles.energy;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.afterStep;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.Simulation;
import particles.scene.ShortRun;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;

/** The energy curves of motions whose energies are known. */
class EnergyHistoryTest {
    private static final double G = 9.81;

    /** m = k = 1, stretched by 1 at the start: E = 1/2, kinetic sin^2(t)/2, potential cos^2(t)/2. */
    private static Simulation spring(String solver, double deltaT, double duration) {
        return simulation(solver, deltaT, duration, """
                particles: [{id: anchor, position: [0, 0, 0], fixed: true}, {id: bob, position: [4, 0, 0]}]
                springs: [{from: anchor, to: bob, stiffness: 1, restLength: 3}]
                effects: []
                blowUpFactor: 1e30
                """);
    }

    private static Simulation simulation(String solver, double deltaT, double duration, String text) {
        return new ShortRun(solver + " clamp " + deltaT + " " + duration, text).getSimulation();
    }

    /**
     * A ball that falls from a height above the origin, and has its velocity turned at one metre above the start of
     * all.
     */
    private static Simulation falling(double height) {
        Simulation simulation = simulation("rk4", 0.125, 1,
                "particles: [{id: ball, position: [0, " + height + ", 0], mass: 2}]");
        simulation.addRule(afterStep(system -> {
            boolean now = system.getTime() == 0.5;
            system.getOwnState()[4] *= now ? -0.5 : 1;
            return now;
        }));
        return simulation;
    }

    private static EnergyHistory observe(Simulation simulation, long stride) {
        EnergyHistory energy = new EnergyHistory(stride);
        simulation.addObserver(energy);
        simulation.run();
        return energy;
    }

    private static Series series(Chart chart, String name) {
        return chart.series().stream().filter(s -> s.name().equals(name)).findFirst().orElseThrow();
    }

    @Test
    void aSpringsEnergiesAreSquaresOfSineAndCosine() {
        EnergyHistory energy = observe(spring("rk4", 0.01, 10), 1);
        Chart chart = energy.chart();
        assertEquals(List.of("total", "kinetic", "springs"),
                chart.series().stream().map(Series::name).toList());
        Series kinetic = series(chart, "kinetic");
        Series potential = series(chart, "springs");
        assertEquals(1001, kinetic.x().length);
        double largest = 0;
        for (int k = 0; k < kinetic.x().length; k++) {
            double sine = StrictMath.sin(kinetic.x()[k]);
            largest = Math.max(largest, Math.abs(kinetic.y()[k] - sine * sine / 2));
            largest = Math.max(largest, Math.abs(potential.y()[k] - (1 - sine * sine) / 2));
        }
        assertBelow(1e-9, largest);    // measured 3.8e-10: half of RK4's phase error h^4 t / 120
        assertEquals(0.5, energy.getScale());
        assertEquals(0.5, energy.getStart());
    }

    @Test
    void aBounceIsAVerticalLine() {
        Series kinetic = series(observe(falling(10), 1).chart(), "kinetic");
        assertArrayEquals(new double[] {0, 0.125, 0.25, 0.375, 0.5, 0.5, 0.625, 0.75, 0.875, 1}, kinetic.x());
        double before = 0.5 * 2 * (G * 0.5) * (G * 0.5);
        assertEquals(before, kinetic.y()[4], 1e-13);             // measured 1.1e-14
        assertEquals(before / 4, kinetic.y()[5], 2.5e-14);       // measured 2.7e-15
    }

    /** The potential of gravity has its zero at the lowest point of the run, wherever the origin is. */
    @Test
    void theZeroOfHeightsChangesNoCurve() {
        EnergyHistory here = observe(falling(2), 1);
        EnergyHistory there = observe(falling(-30), 1);
        List<Series> a = here.chart().series();
        List<Series> b = there.chart().series();
        for (int s = 0; s < a.size(); s++) {
            // measured 1.2e-13, of 600 J: their rounding
            assertArrayEquals(a.get(s).y(), b.get(s).y(), 1e-12, a.get(s).name());
        }
        assertEquals("energy, gravity from its lowest (J)", here.chart().y().label());
        Series gravity = series(here.chart(), "gravity");
        assertEquals(0, java.util.Arrays.stream(gravity.y()).min().orElse(1));
        assertEquals(here.getScale(), there.getScale());
        assertEquals(here.getStart(), there.getStart(), 1e-12, "nor the energies that a console or a file gives");
        assertEquals(a.get(0).y()[0], here.getStart(), "they have the chart's zero");
        assertEquals(a.get(0).y()[a.get(0).y().length - 1], here.getEnd());
    }

    /** On a circle of radius 1 about a centre with mu = 1: kinetic 1/2, potential -1, total -1/2. */
    @Test
    void boundOrbitKeepsItsNegativeEnergy() {
        EnergyHistory energy = observe(simulation("rk4", 0.01, 1, """
                particles: [{id: planet, position: [1, 0, 0], velocity: [0, 1, 0]}]
                effects: [attraction: {strength: 1}]
                """), 1);
        assertEquals(-0.5, energy.getStart(), 1e-15);
        Series total = series(energy.chart(), "total");
        assertEquals(-0.5, total.y()[total.y().length - 1], 1e-8);
        assertEquals(total.y()[total.y().length - 1], energy.getEnd());
    }

    /** Nothing moves: the scale is weight times height, 2 kg on 9.81 m/s^2 over the 3 m between the two particles. */
    @Test
    void aSceneAtRestHasAScale() {
        EnergyHistory energy = observe(simulation("rk4", 0.1, 0, """
                particles: [{id: low, position: [0, 0, 0], mass: 2}, {id: high, position: [5, 3, 0], fixed: true}]
                """), 1);
        assertEquals(2 * G * 3, energy.getScale(), 1e-14);          // measured 0
        assertEquals(0, energy.getLargestDrift());
    }

    @Test
    void everySoManySteps() {
        Series total = observe(spring("rk4", 0.125, 1.25), 4).chart().series().get(0);
        assertArrayEquals(new double[] {0, 0.5, 1, 1.25}, total.x());
        assertThrows(IllegalArgumentException.class, () -> new EnergyHistory(0));
        assertThrows(IllegalStateException.class, () -> new EnergyHistory().chart());
    }

    private static EnergyLedgerRecorder keepBooks(Simulation simulation) {
        EnergyLedgerRecorder books = new EnergyLedgerRecorder(1);
        simulation.addObserver(books);
        simulation.run();
        return books;
    }

    /** Undamped, so that all that Euler adds is his error: the energy grows by 1 + h^2 in each of 8 steps. */
    @Test
    void withoutWorkTheNumericalErrorIsTheDrift() {
        Simulation simulation = spring("euler", 0.125, 1);
        EnergyHistory energy = new EnergyHistory();
        simulation.addObserver(energy);
        EnergyLedgerRecorder books = keepBooks(simulation);
        double growth = StrictMath.pow(1 + 0.125 * 0.125, 8);
        assertEquals(0.5 * growth, energy.getEnd(), 1e-15);
        assertEquals(0.5 * (growth - 1), energy.getLargestDrift(), 1e-15);
        assertEquals(0.5 * (growth - 1), books.getNumericalError(), 1e-15);             // measured 0, as the others
        assertEquals(0.5 * (growth - 1), books.getLargestNumericalError(), 1e-15);
        List<Chart> charts = books.charts(0.5, false);
        assertEquals(1, charts.size());
        assertEquals(growth - 1, charts.get(0).series().get(0).y()[8], 1e-15);
        assertEquals(0, charts.get(0).series().get(0).y()[0]);
    }

    /** Three quarters of what the ball had at the ground, and nothing of it is taken for an error. */
    @Test
    void aBounceIsWorkAndNoError() {
        EnergyLedgerRecorder books = keepBooks(falling(10));
        double before = 0.5 * 2 * (G * 0.5) * (G * 0.5);
        // measured 1.4e-14
        assertEquals(-0.75 * before, books.getWork().values().stream().mapToDouble(w -> w).sum(), 1e-13);
        assertBelow(3e-14 * before, books.getLargestNumericalError());
        Series work = books.charts(before, false).get(0).series().get(0);
        for (int k = 0; work.x()[k] < 0.5; k++) {
            assertEquals(0, work.y()[k]);                   // level until the bounce, and then a vertical line
        }
        assertEquals(0.5,
                work.x()[IntStream.range(0, work.y().length).filter(k -> work.y()[k] < 0).findFirst().orElse(0)]);
        assertTrue(IntStream.range(0, work.y().length).anyMatch(k -> work.x()[k] == 0.5 && work.y()[k] == 0));
        assertEquals(-0.75 * before, work.y()[work.y().length - 1], 1e-13);
    }

    /** Euler with omega deltaT = 1 doubles the energy at every step: 1024 times at the tenth. */
    @Test
    void onlyGrowthByMoreThanAThousandMakesTheAxisLogarithmic() {
        assertFalse(observe(spring("euler", 1, 9), 1).chart().y().log());
        EnergyHistory grown = observe(spring("euler", 1, 30), 1);     // less than 1e9: the spring turns over
        assertTrue(grown.chart().y().log());
        double[] total = grown.chart().series().get(0).y();
        assertEquals(grown.getStart(), total[0]);
        assertEquals(grown.getEnd(), total[total.length - 1]);
        assertFalse(observe(spring("rk4", 0.1, 30), 1).chart().y().log());
        // a falling ball's kinetic energy begins at 0 and grows as t^2; that is no blow-up
        assertFalse(observe(simulation("rk4", 1e-4, 1, "particles: [{id: ball, position: [0, 0, 0]}]"), 1)
                .chart().y().log());
    }

    @Test
    void sizesOfWorkAndErrorAreDrawnOnALogarithmicAxis() {
        EnergyLedgerRecorder books = keepBooks(spring("euler", 1, 20));
        Chart error = books.charts(0.5, true).get(0);
        assertTrue(error.y().log());
        assertEquals("|error| / scale", error.y().label());
        double[] sizes = error.series().get(0).y();
        assertEquals(books.getLargestNumericalError() / 0.5, sizes[sizes.length - 1]);
    }

    /**
     * A mean of A sin^2(omega t) over T = 15 s / 32 is off A/2 by at most A / (2 omega T), 16.8 J here; measured 15.3
     * J, and 0.07 J for the mean of all.
     */
    @Test
    void energiesThatWouldFillAnAreaAreDrawnAsMeans() {
        Chart dense = observe(simulation("rk4", 0.002, 15, """
                particles: [{id: anchor, position: [0, 0, 0], fixed: true}, {id: bob, position: [4, 0, 0]}]
                springs: [{from: anchor, to: bob, stiffness: 986.96, restLength: 3}]
                effects: []
                """), 1).chart();
        assertEquals(List.of("total", "mean kinetic", "mean springs"),
                dense.series().stream().map(Series::name).toList());
        double[] means = dense.series().get(1).y();
        for (double mean : means) {
            assertEquals(246.74, mean, 16.8, "half of 493.48 J");
        }
        assertEquals(246.74, java.util.Arrays.stream(means).average().orElseThrow(), 0.2);
    }

    @Test
    void workThatDrivesHasALookOfItsOwn() {
        EnergyLedgerRecorder books = keepBooks(new ShortRun("rk4 clamp 0.01 1",
                "particles: [{id: ball, position: [0, 0, 0]}]\n"
                + "effects: [drag: {coefficient: 1}, wind: {mean: [1, 0, 0]}]").getSimulation());
        assertEquals(Map.of("drag (driven)", Look.DRIVEN, "drag (dissipated)", Look.WORK),
                books.charts(1, false).get(0).series().stream().collect(Collectors.toMap(Series::name, Series::look)));
    }
}
