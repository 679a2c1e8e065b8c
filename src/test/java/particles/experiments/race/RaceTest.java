package particles.experiments.race;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import particles.experiments.race.Race.FrameStates;
import particles.experiments.race.Race.Lane;
import particles.experiments.race.Race.Result;
import particles.experiments.runs.EqualTime;
import particles.experiments.runs.EqualWork;
import particles.experiments.runs.EqualWork.Match;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SolverChoice;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;
import particles.view.Chart;
import particles.view.Series;
import particles.view.Series.Mark;
import particles.view.DataTable;

class RaceTest {
    private static final SceneDescription SPIRAL = TestScenes.named("11-euler-spiral");
    private static final SceneDescription CHAIN = TestScenes.named("16-soft-chain");
    private static final Race.ObserverFactory NOBODY = (scene, solver, extent) -> List.of();

    private static SceneDescription lasting(SceneDescription scene, double duration) {
        return scene.withSolver("rk4").withDuration(duration);
    }

    private static Result run(SceneDescription scene, String solvers, int frames, Race.ObserverFactory observers) {
        return new Race(scene, SolverChoice.list(solvers), frames, Outcome::seconds).run(observers,
                (part, what) -> { });
    }

    /** A race by a clock of the test's own. */
    private static Result timed(SceneDescription scene, String solvers, int frames, ToDoubleFunction<Outcome> clock) {
        return new Race(scene, SolverChoice.list(solvers), frames, clock).run(NOBODY, (part, what) -> { });
    }

    @Test
    void evaluationsDifferByLessThanAStep() {
        Result race = run(lasting(CHAIN, 3), "midpoint, rk4, adams, verlet, yoshida4, dormand-prince", 30, NOBODY);
        assertFalse(race.equalTime());
        assertEquals(300, race.shares().work());                             // 75 steps of rk4
        assertEqualWork(race);
        assertHas(RaceCharts.title(race), "equal work, 300 evaluations for the whole race");
    }

    /** With contacts, a shorter step may cost less: no solver raises the work of all by 0.4 % again and again. */
    @Test
    void aCostThatJumpsIsNoReasonToSearchAgain() {
        List<String> searches = new ArrayList<>();
        SceneDescription marbles = lasting(TestScenes.named("13-marbles-in-a-groove"), 2);
        assertEquals(4000, EqualWork.ofFrames(marbles, 4000, 10).share(SolverChoice.list(
                "euler, midpoint, rk4, symplectic-euler, verlet"), (part, what) -> searches.add(what)).work());
        assertEquals(5, searches.size(), searches.toString());
    }

    /** Verlet's last kick does not converge in its first step: what this cost is not the cost of a billion steps. */
    @Test
    void aSolverThatFailsAtOnceHasItsShare() {
        Result race = run(TestScenes.named("12").withDeltaT(0.01).withDuration(0.5), "verlet", 5, NOBODY);
        assertEquals("until 0 s", RaceCharts.mean(race.lanes().get(0)));
        assertEquals(200, race.lanes().get(0).match().evaluations(), 10);
    }

    /** In longer steps its last kick does not converge, and the 101 evaluations of this failure fit any share. */
    @Test
    void aSolverTakesStepsThatItCanMake() {
        Match verlet = EqualWork.ofFrames(lasting(TestScenes.named("09"), 0.1), 200, 10).share(SolverChoice.list(
                "verlet"), (part, what) -> { }).matches().get(0);
        assertTrue(verlet.whole(), verlet.toString());
        assertEquals(0.002, verlet.setting().deltaT());
    }

    /** Drops are born and die: the third of one run need not be the third of another. */
    @Test
    void whoIsNearestIsNotSaidWhereParticlesAreBorn() {
        Result race = run(lasting(TestScenes.named("27"), 0.5), "rk4, verlet", 5, NOBODY);
        assertEquals("", RaceCharts.mean(race.lanes().get(0)));
        assertTrue(Arrays.stream(race.lanes().get(0).distance()).allMatch(Double::isNaN));
    }

    /** A pace at which rk4 blows up is the one that it would have to its end: 600 steps of four evaluations. */
    @Test
    void aPaceThatFailsCountsToItsEnd() {
        Result race = timed(TestScenes.named("12").withDeltaT(0.01), "backward-euler", 5, Outcome::evaluations);
        assertEquals(2400, race.shares().work(), 240);
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
        Result race = run(scene, "euler, rk4", 20, (built, solver, extent) -> {
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
        assertEquals(Digits.few(Math.sqrt(Arrays.stream(off).map(d -> d * d).average().orElseThrow())) + " m",
                RaceCharts.mean(race.lanes().get(1)));
        for (Chart chart : List.of(RaceCharts.distance(race), RaceCharts.energy(race))) {
            Series crosses = chart.series().get(1);
            assertEquals(Mark.FAILURES, crosses.mark());
            assertEquals(left, crosses.x()[0], 0.1, "within a frame");
        }
        DataTable table = RaceCharts.table(race);
        assertEquals(left, cell(table, 0, "left the race at (s)"));
        double step = euler.match().setting().deltaT();
        assertEquals(left / step, (Long) cell(table, 0, "evaluations"), 1,
                "evaluations until then, and not those of its share: " + euler.match().evaluations());
        assertHas(cell(table, 0, "what went wrong").toString(), "went where the reference never comes near");
    }

    /** By a clock on which a step takes a microsecond for each evaluation and two for itself. */
    @Test
    void implicitSolversGetEqualTime() {
        Result result = timed(lasting(CHAIN, 3), "rk4, implicit-midpoint, verlet", 10, outcome -> 1e-6
                * (outcome.evaluations() + 2 * outcome.steps()));
        assertTrue(result.equalTime());
        assertTrue(result.shares().slowest().isEmpty(), "all can do with what rk4 takes");
        assertEquals(450e-6, result.shares().work(), 1e-18, "rk4: 75 steps of 4 + 2");
        for (Lane lane : result.lanes()) {
            assertEquals(450e-6, lane.match().seconds(), EqualTime.CLOSE * 450e-6, lane.label());
        }
        assertEquals(150, Math.round(3 / result.lanes().get(2).match().setting().deltaT()), 1.5,
                "verlet: steps of 1 + 2");
        assertHas(RaceCharts.title(result), "equal time, 0.450 ms each");
    }

    /** Radau's loosest tolerance needs more than rk4 at the scene's step: now all take as long as that. */
    @Test
    void whoCannotDoWithLessSetsTheTimeOfAll() {
        // rk4 makes 240 evaluations, radau 304
        SceneDescription scene = CHAIN.withSolver("rk4").withDeltaT(0.05).withDuration(3);
        Result result = timed(scene, "rk4, backward-euler, radau, verlet", 30, outcome -> 1e-6 * outcome.evaluations());
        assertEquals("radau", result.shares().slowest().orElseThrow().label());
        Lane radau = result.lanes().get(2);
        assertEquals(0.1, radau.match().setting().tolerance().orElseThrow(), "the loosest there is");
        assertEquals(1e-6 * radau.drift().outcome().evaluations(), result.shares().work(), 1e-18);
        assertTrue(result.shares().work() > 1.05 * 240e-6,
                "more than rk4 at the scene's step: " + result.shares().work());
        for (Lane lane : result.lanes()) {
            assertEquals(result.shares().work(), 1e-6 * lane.drift().outcome().evaluations(),
                    EqualTime.CLOSE * result.shares().work(), lane.label());
        }
    }

    /** By a clock on which radau's cheap-looking loose runs take long: the cheapest is one with a tighter tolerance. */
    @Test
    void aLooserToleranceMayTakeLonger() {
        Result result = timed(lasting(CHAIN, 3), "rk4, radau", 30, outcome -> 1e-6
                * (outcome.steps() <= 30 && outcome.evaluations() < 400 ? 400_000.0 / outcome.evaluations()
                        : outcome.evaluations()));
        assertEquals("radau", result.shares().slowest().orElseThrow().label());
        assertTrue(result.lanes().get(1).match().setting().tolerance().orElseThrow() < 0.05);
        assertTrue(result.shares().work() >= 400e-6 && result.shares().work() < 600e-6,
                "now " + result.shares().work());
        assertEquals(0, EqualTime.spread(result.shares()), EqualTime.CLOSE);
    }

    /**
     * A machine on which every fifth run takes thrice as long, and all others up to 10 % more: medians are what counts.
     */
    @Test
    void aNoisyMachineDoesNotMatter() {
        Random random = new Random(5);
        Result result = timed(lasting(CHAIN, 3), "rk4, backward-euler, radau", 30, outcome ->
                1e-6 * (outcome.evaluations() + 2 * outcome.steps())
                        * (random.nextInt(5) == 0 ? 3 : 1 + 0.1 * random.nextDouble()));
        assertEquals(0, EqualTime.spread(result.shares()), EqualTime.CLOSE);
        double[] pure = result.lanes().stream().mapToDouble(lane -> lane.drift().outcome().evaluations()
                + 2 * lane.drift().outcome().steps()).toArray();
        double most = Arrays.stream(pure).max().orElseThrow();
        double least = Arrays.stream(pure).min().orElseThrow();
        assertTrue(most / least < 1.15, "without the noise they differ by " + (most / least - 1));     // 0.016
    }

    /**
     * By a clock that charges an implicit solver's evaluations hundredfold nothing can be equal, and the title says so.
     */
    @Test
    void whatCannotBeEqualIsSaid() {
        Result result = timed(lasting(CHAIN, 3), "rk4, radau", 30, outcome ->
                outcome.steps() == 30 || outcome.steps() == 15 ? 1 : 1e-6 * outcome.evaluations());
        assertHas(RaceCharts.title(result), "no equal time, up to");
    }

    /** By evaluations too: bulirsch-stoer needs more than the 800 of rk4 with a step of 0.06 s. */
    @Test
    void whoNeedsMoreEvaluationsSetsThoseOfAll() {
        Result race = run(CHAIN.withSolver("rk4").withDeltaT(0.06).withDuration(12),
                "midpoint, rk4, step-doubling, bulirsch-stoer, verlet", 240, NOBODY);
        assertEquals("bulirsch-stoer", race.shares().slowest().orElseThrow().label());
        assertTrue(race.shares().work() > 800, "now " + race.shares().work());
        assertEqualWork(race);
    }

    /** What was measured is what ran, with all frames, and differs from the work of all by less than a step. */
    private static void assertEqualWork(Result race) {
        for (Lane lane : race.lanes()) {
            if (lane.left().isEmpty()) {
                long evaluations = lane.drift().outcome().evaluations();
                assertEquals(lane.match().evaluations(), evaluations, lane.label());
                assertTrue(Math.abs(evaluations - race.shares().work()) < lane.match().aStep(), lane.label());
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
