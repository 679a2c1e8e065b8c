package particles.experiments.race;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.MidpointSolver;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import particles.experiments.race.Race.FrameStates;
import particles.experiments.race.Race.Lane;
import particles.experiments.race.Race.Result;
import particles.experiments.runs.EqualWork;
import particles.experiments.runs.EqualWork.Match;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SolverChoice;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Series;
import particles.view.Series.Mark;

class RaceTest {
    private static final SceneDescription SPIRAL = TestScenes.named("11-euler-spiral");
    private static final SceneDescription CHAIN = TestScenes.named("16-soft-chain");
    private static final Race.ObserverFactory NOBODY = (scene, solver) -> List.of();

    private static SceneDescription lasting(SceneDescription scene, double duration) {
        return scene.withSolver("rk4").withDuration(duration);
    }

    private static Result run(SceneDescription scene, String solvers, int frames, Race.ObserverFactory observers) {
        return new Race(scene, SolverChoice.list(solvers), frames).run(observers, (part, what) -> { });
    }

    @Test
    void evaluationsDifferByLessThanAStep() {
        Result race = run(lasting(CHAIN, 3), "midpoint, rk4, adams, verlet, yoshida4, dormand-prince", 30, NOBODY);
        assertEquals(300, race.work());                             // 75 steps of rk4
        assertEqualWork(race);
        assertHas(RaceCharts.title(race), "equal work, 300 evaluations for the whole race");
    }

    /** What Newton's method evaluates counts. Radau cannot do with the 300 of rk4 at the scene's step: all get 350. */
    @Test
    void implicitSolversGetEqualWorkToo() {
        Result race = run(lasting(CHAIN, 3), "rk4, backward-euler, implicit-midpoint, radau", 30, NOBODY);
        assertTrue(race.work() > 300 && race.work() < 400, "measured 350, now " + race.work());
        assertEqualWork(race);
    }

    /** Midpoint, which counts its steps. */
    public static final class Counted extends DESolver {
        private static final AtomicInteger STEPS = new AtomicInteger();
        private final DESolver midpoint = new MidpointSolver();

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            STEPS.incrementAndGet();
            midpoint.stepState(source, deltaT);
        }
    }

    /**
     * The first run has a step for each four evaluations, 75; the second follows by proportion and costs what is
     * wanted, and the number of steps that it asks for has been tried.
     */
    @Test
    void proportionFindsTheStepInTwoRuns() {
        SolverChoice counted = SolverChoice.of(Counted.class.getName());
        int before = Counted.STEPS.get();
        Match match = new EqualWork(lasting(CHAIN, 3), 300, 30).share(List.of(counted), (part, what) -> { }).matches()
                .get(0);
        assertEquals(75 + 150, Counted.STEPS.get() - before);
        assertEquals(150, match.steps());
        assertEquals(300, match.cost());
    }

    /** In longer steps its last kick does not converge, and the 101 evaluations of this failure fit any share. */
    @Test
    void aSolverTakesStepsThatItCanMake() {
        Match verlet = new EqualWork(lasting(TestScenes.named("09"), 0.1), 200, 10).share(SolverChoice.list("verlet"),
                (part, what) -> { }).matches().get(0);
        assertTrue(verlet.whole(), verlet.toString());
        assertEquals(0.1 / 53, verlet.setting().deltaT(), 1e-12);       // 50 steps are enough, 33 are not
    }

    /** Drops are born and die: the third of one run need not be the third of another. */
    @Test
    void whoIsNearestIsNotSaidWhereParticlesAreBorn() {
        Result race = run(lasting(TestScenes.named("27"), 0.5), "rk4, verlet", 5, NOBODY);
        assertEquals("", RaceCharts.mean(race.lanes().get(0)));
        assertTrue(Arrays.stream(race.lanes().get(0).distance()).allMatch(Double::isNaN));
    }

    /** x = cos t, v = -sin t. */
    @Test
    void referenceIsTheExactMotion() {
        Result race = run(lasting(SPIRAL, 10), "rk4, midpoint", 77, NOBODY);
        Lane midpoint = race.lanes().get(1);
        double worst = 0;
        for (int k = 0; k < race.times().length; k++) {                 // distances measured off by 4.3e-19
            double x = race.reference().get(k)[6];
            worst = Math.max(worst, Math.abs(x - StrictMath.cos(race.times()[k])));
            assertEquals(Math.abs(x - midpoint.states().get(k)[6]) / Math.sqrt(2), midpoint.distance()[k], 4e-18,
                    "root mean square over two particles, one of them fixed");
        }
        assertTrue(worst < 1e-10, "now " + worst);              // 1.7e-11: frames are ends of its steps
        assertTrue(midpoint.distance()[77] > 1e-3, "midpoint is not exact");
    }

    /** At the frames' times observers see the states that were measured: the ghost is the reference, bit for bit. */
    @Test
    void observersSeeWhatIsMeasured() {
        List<Optional<SolverChoice>> order = new ArrayList<>();
        List<FrameStates> seen = new ArrayList<>();
        SceneDescription scene = lasting(CHAIN, 2);
        Result race = run(scene, "euler, rk4", 20, (built, solver) -> {
            order.add(solver);
            FrameStates states = new FrameStates(20 / scene.duration());
            seen.add(states);
            return List.of(states);
        });
        assertTrue(order.get(0).isEmpty(), "the reference comes first");
        assertEquals(List.of("euler", "rk4"), order.subList(1,
                3).stream().map(solver -> solver.orElseThrow().label()).toList());
        for (int k = 0; k < 3; k++) {
            List<double[]> measured = k == 0 ? race.reference() : race.lanes().get(k - 1).states();
            assertEquals(21, measured.size());
            for (int f = 0; f < 21; f++) {
                assertArrayEquals(measured.get(f), seen.get(k).states.get(f));
            }
        }
    }

    private static Object cell(DataTable table, int row, String column) {
        List<String> names = table.columns().stream().map(DataTable.Column::name).toList();
        return table.rows().get(row).get(names.indexOf(column));
    }

    @Test
    void whoLeavesIsShownAsSuch() {
        Result race = run(lasting(CHAIN, 4), "euler, verlet", 40, NOBODY);
        Lane euler = race.lanes().get(0);
        double left = euler.left().orElseThrow();
        assertTrue(left > 1 && left < 4, "left at " + left);
        assertEquals((int) (left * 10) + 1, euler.states().size(), "frames until then");
        assertTrue(race.lanes().get(1).left().isEmpty());
        assertEquals("until " + Digits.few(left) + " s", RaceCharts.mean(euler));
        double[] off = race.lanes().get(1).distance();
        assertEquals("rms " + Digits.few(Math.sqrt(Arrays.stream(off).map(d -> d * d).average().orElseThrow())) + " m",
                RaceCharts.mean(race.lanes().get(1)));
        for (Chart chart : List.of(RaceCharts.distance(race), RaceCharts.energy(race))) {
            Series crosses = chart.series().get(1);
            assertEquals(Mark.FAILURES, crosses.mark());
            assertEquals(left, crosses.x()[0], 0.1, "within a frame");
        }
        DataTable table = RaceCharts.table(race);
        assertEquals(left, cell(table, 0, "left the race at (s)"));
        assertEquals(Double.NaN, cell(table, 0, "distance, rms (m)"), "a part of the race is not compared");
        assertEquals(left / euler.drift().setting().deltaT(), (Long) cell(table, 0, "evaluations"), 1,
                "evaluations until then, and not those of its share");
        assertHas(cell(table, 0, "what went wrong").toString(), "the numerical error is ");
    }

    /** All frames are there, and the evaluations differ from the work of all by less than a step. */
    private static void assertEqualWork(Result race) {
        for (Lane lane : race.lanes()) {
            if (lane.left().isEmpty()) {
                Outcome outcome = lane.drift().outcome();
                assertEquals(race.work(), outcome.evaluations(), (double) outcome.evaluations() / outcome.steps(),
                        lane.label());
                assertEquals(race.times().length, lane.states().size(), lane.label());
            }
        }
    }

    /** An adaptive solver is compared at the ends of its steps; the cubic between them is 1e-3 off. */
    @Test
    void whatIsInterpolatedIsNoError() {
        SceneDescription fine = CHAIN.withSolver("rk4").withDeltaT(0.002).withDuration(3);
        Result race = run(fine, "dormand-prince, rk4", 300, NOBODY);
        Lane lane = race.lanes().get(0);
        int known = (int) Arrays.stream(lane.distance()).filter(d -> d >= 0).count();
        assertEquals(151, known, "150 steps and the start");
        assertEquals(301, lane.distance().length);
        double worst = Arrays.stream(lane.distance()).filter(d -> d >= 0).max().orElseThrow();
        assertTrue(worst < 5e-9, "now " + worst);               // 5.3e-10, as rk4 too
        assertEquals(150, RaceCharts.distance(race).series().get(0).x().length, "no gaps, and 0 is not on the axis");
        assertEquals(300, RaceCharts.distance(race).series().get(1).x().length, "rk4 has no steps within steps");
    }
}
