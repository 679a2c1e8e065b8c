package particles.scene;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertMatches;
import static particles.Texts.assertStarts;

import deSolvers.DESolverException;
import deSolvers.implicit.BackwardEulerSolver;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.SimulationException;
import particles.effects.PointAttraction;
import particles.energy.EnergyRecorder;
import particles.law.ParticleForce;
import particles.law.Vector3;
import particles.scene.format.SceneDescription;

/** The line at the end of a blow-up, and that its advice is good. */
class BlowUpMessageTest {
    /** A chain of three between two walls, k = 400, m = 1: one spring alone has omega = sqrt(800), all less than 40. */
    private static final String CHAIN = """
            title: A chain
            teaches: When a step is too long.
            solver: SOLVER
            deltaT: 0.2
            duration: 60
            particles:
              - {id: left, position: [0, 0, 0], fixed: true}
              - {id: a, position: [1, 0, 0]}
              - {id: b, position: [2, 0, 0], velocity: [0.1, 0, 0]}
              - {id: c, position: [3, 0, 0]}
              - {id: right, position: [4, 0, 0], fixed: true}
            springs:
              - {from: left, to: a, stiffness: 400, restLength: 0.8DAMPING}
              - {from: a, to: b, stiffness: 400, restLength: 0.8DAMPING}
              - {from: b, to: c, stiffness: 400, restLength: 0.8DAMPING}
              - {from: c, to: right, stiffness: 400, restLength: 0.8DAMPING}
            """;

    private static SceneDescription chain(String solver, double damping) {
        String text = CHAIN.replace("SOLVER", solver).replace("DAMPING", damping > 0 ? ", damping: " + damping : "");
        return TestScenes.read(text);
    }

    private static String blowUp(SceneDescription scene) {
        return blowUp(SceneBuilder.build(scene));
    }

    private static String blowUp(Scene scene) {
        return new BlowUpMessage(scene, assertThrows(SimulationException.class, scene.simulation()::run),
                name -> "--" + name).lines();
    }

    /**
     * Gershgorin: sqrt(4 * 400) * 0.2 = 8 = 2.83 * 2.8284; 0.9 * 2.8284 / 40 = 0.0636. With c = 3 N s/m, Euler is
     * stable up to c/k = 7.5 ms, so "at any deltaT" would not be true. What the solver says is part of the lines.
     */
    @ParameterizedTest
    @CsvSource(delimiterString = "->", quoteCharacter = '"', textBlock = """
            rk4 -> 0 -> rk4 stopped at t = [\\d.]+ s at particle '[abc]': the kinetic energy is [\\d.e]+ J, above the \
            limit of [\\d.e]+ J\\ndeltaT is too long for the fastest vibration, by a factor of up to 2\\.83 \
            \\(\\|lambda\\| \\* deltaT is at most 8; the limit of rk4 is 2\\.83; stiffest spring: 'a' to 'b'\\)\\n\
            try --deltaT=0\\.063, which takes about 4 times the work
            euler -> 3 -> .*\\nsprings with little damping gain energy with euler unless deltaT is very short\\n\
            try --solver=rk4 with --deltaT=.*
            euler -> 0 -> .*\\nundamped springs gain energy with euler at any deltaT\\n\
            try --solver=verlet with --deltaT=0\\.045, which takes about 5 times the work
            verlet -> 30 -> verlet stopped at t = 0 s: the velocity at the end of the step did not converge in 100 \
            iterations.*\\ndeltaT is too long for the fastest damping, by a factor of up to [\\d.]+ \
            \\(c/m \\* deltaT is at most .*\\ntry --deltaT=0\\.00\\d+, which takes about \\d+ times the work
            """)
    void theLinesSayWhatHappenedWhyAndWhatToTry(String solver, double damping, String pattern) {
        String lines = blowUp(chain(solver, damping));
        assertMatches(lines, pattern);
    }

    /** A particle that comes to the point that attracts it; a scene that begins with one there is refused. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "rk4", "dormand-prince", "radau"})
    void aForceWithoutAValueIsNamedAndNoSolverAdvised(String solver) {
        Scene scene = TestScenes.build(CHAIN.replace("SOLVER", solver).replace("DAMPING", "")
                + "effects: [gravity]\n");
        scene.system().addEffect(new PointAttraction(scene.system().getParticles(), new Vector3(3, 0, 0), 1, 0));
        assertEquals(solver + " stopped at t = 0 s at particle 'c': the force 'attraction' is not finite there\n"
                + "no solver can go on from there\ntry other positions in the scene", blowUp(scene));
    }

    /** A force of one's own, as x^3, is stiff far out: the springs' limit says nothing of it. */
    @Test
    void aForceOfOnesOwnIsNotSaidToBeWithinTheLimit() {
        Scene scene = SceneBuilder.build(TestScenes.read(CHAIN.replace("SOLVER", "rk4").replace("DAMPING", "").replace(
                "stiffness: 400", "stiffness: 1")));
        scene.system().addEffect(new ParticleForce(scene.system().getParticles()) {
            @Override
            public String getName() {
                return "quartic";
            }

            @Override
            protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                return position.times(-1e4 * position.dot(position));
            }
        });
        assertEquals("springs are not the cause: deltaT is within their limit with rk4",
                blowUp(scene).lines().toList().get(1));
    }

    /** Whatever the solver and the damping, the run with the advice does not blow up. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            rk4, 0
            rk4, 30
            euler, 0
            euler, 30
            midpoint, 0
            midpoint, 30
            symplectic-euler, 0
            verlet, 0
            verlet, 30
            yoshida4, 0
            yoshida4, 30
            adams, 0
            adams, 30
            """)
    void theAdviceHelps(String solver, double damping) {
        SceneDescription chain = chain(solver, damping);
        String line = blowUp(SceneBuilder.build(chain));
        Scene advised = SceneBuilder.build(Advised.by(line, chain).orElseThrow());
        advised.simulation().run();
        assertEquals(60, advised.system().getTime(), 1e-9);
        double energy = advised.system().getKineticEnergy(advised.system().getOwnState());
        assertBelow(0.1, energy, line);  // 0.005 J and what the springs hold at the start
    }

    /** Damping of 1e30 N s/m on masses of 1e-40 kg decays at 1e70 /s and more; no option takes a step so short. */
    @Test
    void noStepIsAdvisedThatTheOptionRefuses() {
        String text = CHAIN.replace("SOLVER", "rk4").replace("DAMPING", ", damping: 1e30")
                .replaceAll("(\\{id: [abc],)", "$1 mass: 1e-40,");
        String line = blowUp(TestScenes.build(text));
        assertTrue(line.endsWith("\ntry softer springs or larger masses, as no deltaT may be below 1e-40 s"), line);
    }

    /** The times of the bounces converge: without a rest speed, they are more than any number in one step. */
    @ParameterizedTest
    @ValueSource(strings = {"ground: {restitution: 0.8, restSpeed: 0}",
        "collisions: {radius: 0.25, restitution: 0.8, restSpeed: 0}"})
    void bouncesWithoutEndNameTheRestSpeed(String rule) {
        String lines = blowUp(new ShortRun("rk4 exact 0.01 20", """
                particles: [{id: a, position: [0, 1, 0]}, {id: stand, position: [0, -0.5, 0], fixed: true}]
                rules: [%s]
                """.formatted(rule)).getScene());
        assertMatches(lines, "rk4 stopped at t = 4\\.06 s: contacts make no headway: .*\nwith restSpeed 0, bounces"
                + " become ever smaller and never end\ntry restSpeed: 0\\.01 in the scene's rule");
    }

    /** A rope of rods that swings down from the horizontal and cracks like a whip. */
    private static Scene whip(String solver) {
        String particles = IntStream.rangeClosed(0, 30).mapToObj(i -> "  - {id: p%d, position: [%s, 0, 0], %s}%n"
                .formatted(i, i * 0.0625, i == 0 ? "fixed: true" : "mass: 0.01")).collect(Collectors.joining());
        String rods = IntStream.range(0, 30).mapToObj(i -> "  - {from: p%d, to: p%d}%n".formatted(i, i + 1))
                .collect(Collectors.joining());
        return new ShortRun(solver + " clamp 0.02 2", "particles:\n" + particles + "rods:\n" + rods).getScene();
    }

    /** Rods have no stability limit that could be told; an adaptive solver finds its steps, and keeps the energy. */
    @ParameterizedTest
    @ValueSource(strings = {"verlet", "rk4", "midpoint", "euler", "symplectic-euler", "yoshida4", "adams"})
    void whatTurnsFastOnRodsWantsAnAdaptiveSolver(String solver) {
        String line = blowUp(whip(solver));
        assertTrue(line.endsWith("\nwithout springs, it is not known how long deltaT may be"
                + "\ntry --solver=dormand-prince, which chooses its own sub-steps"), line);
        assertFalse(line.contains("damping") || line.contains("NaN"), line);
        Scene advised = whip("dormand-prince");
        double before = advised.system().getEnergy(advised.system().getOwnState(), 0);
        advised.simulation().run();
        double after = advised.system().getEnergy(advised.system().getOwnState(), 2);
        assertEquals(before, after, 1e-4 * 0.3 * 9.81);         // of its weight times a metre
    }

    @Test
    void aRunThatWentWrongIsToldFromWhenOn() {
        Scene scene = SceneBuilder.build(chain("euler", 0));
        String line = new BlowUpMessage(scene, new SimulationException(SimulationException.End.WRONG_MOTION, 1.25, 2,
                "the numerical error of 3 J is larger"), name -> "--" + name).lines();
        assertStarts(line, "from t = 1.25 s on the motion by euler is wrong: the numerical error of 3 J is"
                + " larger\nundamped springs gain energy with euler at any deltaT\ntry ");
    }

    /** A straight pair of rods between a wall and a hand that pulls away: no step is short enough for that. */
    @Test
    void whatRodsCannotDoIsSaidWithoutAdvice() {
        Scene torn = new ShortRun("rk4 clamp 0.01 2", """
                particles:
                  - {id: wall, position: [0, 0, 0], fixed: true}
                  - {id: middle, position: [1, 0, 0]}
                  - {id: hand, position: [2, 0, 0], fixed: true}
                rods: [{from: wall, to: middle}, {from: middle, to: hand}]
                rules: [glide: {particle: hand, to: [3, 0, 0], duration: 1}]
                """).getScene();
        assertMatches(blowUp(torn), "rk4 stopped at t = [\\d.e-]+ s at particle 'middle': the rods"
                + " and wires connected to particle 'middle' contradict each other: no forces can satisfy them all");
    }

    private static Scene stiffCloth(String solver) {
        return new ShortRun(solver + " clamp 0.02 3", """
                shapes:
                  - cloth: {id: c, corner: [0, 0, 0], across: [0.4, 0, 0], down: [0, 0, 0.4], columns: 5, rows: 5,
                            mass: 0.01, fixed: [top], structural: {stiffness: 1e6},
                            shear: {stiffness: 1e6}, bend: {stiffness: 1e6}}
                """).getScene();
    }

    /** Ends a run as the command does, by its numerical error. */
    private static Scene withLimit(Scene scene) {
        new EnergyRecorder(scene.simulation(), scene.energyEstimate(), 1).attachTo(scene.simulation(), List.of());
        return scene;
    }

    /** Implicit midpoint damps nothing and adds energy where springs buckle, at shorter steps too. */
    @Test
    void whatBucklesWantsDamping() {
        String line = blowUp(withLimit(stiffCloth("implicit-midpoint")));
        assertTrue(line.endsWith("\nimplicit-midpoint has no stability limit, but it adds energy where springs"
                + " buckle or turn\ntry --solver=linearised-euler, which solves one linear system per step and damps"
                + " what is too fast for it"), line);
        withLimit(stiffCloth("linearised-euler")).simulation().run();
    }

    /** Without springs nothing buckles; that Newton's method fails does not say that deltaT is too long. */
    @ParameterizedTest
    @ValueSource(strings = {"backward-euler", "implicit-midpoint"})
    void whereThereAreNoSpringsNoneIsBlamed(String solver) {
        SceneDescription orbits = TestScenes.named("24-orbits");
        String line = blowUp(orbits.withSolver(solver));
        assertTrue(line.endsWith("\n" + solver + " has no stability limit, but its equations could not be"
                + " solved\ntry --solver=dormand-prince, which chooses its own sub-steps"), line);
        SceneBuilder.build(orbits.withSolver("dormand-prince")).simulation().run();
    }

    private static final String ROPE = """
            title: A rope over a rough ball
            teaches: Friction on what is elastic.
            solver: backward-euler
            deltaT: 0.005
            duration: 0.6
            impact: exact
            shapes:
              - rope: {start: [-0.6, 0.6, 0.02], end: [0.7, 0.6, 0.02], particles: 12, totalMass: 0.2,
                       structural: {stiffness: 200, damping: 0.1}}
            effects:
              - gravity
            rules:
              - sphere: {centre: [0, 0, 0], radius: 0.55, restitution: 0.2, friction: {law: coulomb, coefficient: 0.4}}
            """;

    /** Newton's method found no solution while a rope slides on a rough ball and is about to stop. */
    @Test
    void frictionThatTurnsTooFastIsNamedWithWhatHelps() {
        SceneDescription rope = TestScenes.read(ROPE);
        Scene sliding = SceneBuilder.build(rope.withDuration(0.4));
        sliding.simulation().run();
        BlowUpMessage message = new BlowUpMessage(sliding, new SimulationException(0.4, -1, "a step failed",
                new DESolverException(BackwardEulerSolver.class, 0.4, 0.005, -1,
                        "Newton's iteration did not converge: 7 iterations", "")), name -> "--" + name);
        String line = message.lines();
        assertMatches(line, "backward-euler stopped at t = 0\\.\\d+ s: Newton's iteration did not converge: .*"
                + "\nsomething is about to stop or to begin to slide, and there Coulomb friction changes its"
                + " direction too fast for backward-euler\n"
                + "try --solver=rk4, which steps across the change");
        Scene advised = SceneBuilder.build(Advised.by(line, rope).orElseThrow());
        advised.simulation().run();
        assertEquals(0.6, advised.system().getTime(), 1e-12);
    }

    /** A failure that is not the solver's has another line, and no advice. */
    @Test
    void otherFailuresAreNotFrictions() {
        Scene scene = TestScenes.build(ROPE);
        scene.simulation().start();
        assertEquals("backward-euler stopped at t = 0 s: the clock does not move", new BlowUpMessage(scene,
                new SimulationException(0, -1, "the clock does not move", null), name -> "--" + name).lines());
    }

    /** Both failed here before friction acted as an impulse in the step in which it stops a particle. */
    @ParameterizedTest
    @ValueSource(strings = {"verlet", "implicit-midpoint"})
    @Tag("slow")
    void frictionOnARestingJellyEndsNoRun(String solver) {
        Scene scene = SceneBuilder.build(TestScenes.named("10-jelly-block").withSolver(solver).withDuration(0.6));
        scene.simulation().run();
        assertEquals(0.6, scene.system().getTime(), 1e-9);
    }
}
