package particles.rules;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.afterStep;
import static particles.Systems.onMove;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.SimulationException;
import particles.law.SeededRandom;
import particles.law.Vector3;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface.Bounce;
import particles.reactions.RigidConstraints;
import particles.scene.ShortRun;
import particles.spec.messages.InvalidInputException;

/** Hard balls against the closed forms of impacts, statics and the laws of conservation. */
class CollisionsTest {
    private static final double G = ShortRun.G;

    static List<SolverInfo> solvers() {
        return SolverCatalog.all();
    }

    /** n balls of 1, 2, 3 kg in a box of 1 m, with 1 m/s in random directions; any solver moves them exactly. */
    private static ShortRun gas(String steps, int n, double radius, double restitution) {
        SeededRandom random = new SeededRandom(7);
        int side = (int) Math.ceil(Math.cbrt(n));
        String balls = IntStream.range(0, n).mapToObj(i -> {
            Vector3 v = random.nextDirection(new Vector3(0, 1, 0), Math.PI);
            return String.format(Locale.ROOT,
                    "  - {id: b%d, mass: %d, position: [%.4f, %.4f, %.4f], velocity: [%s, %s, %s]}%n", i, 1 + i % 3,
                    (i % side + 0.5) / side, (i / side % side + 0.5) / side, (i / side / side + 0.5) / side, v.x(),
                    v.y(), v.z());
        }).collect(Collectors.joining());
        String walls = IntStream.range(0, 6).mapToObj(k -> String.format(
                "  - plane: {point: [%1$d, %1$d, %1$d], normal: [%2$s], restitution: 1, restSpeed: 0}%n", k / 3,
                List.of("1, 0, 0", "0, 1, 0", "0, 0, 1", "-1, 0, 0", "0, -1, 0", "0, 0, -1").get(k)))
                .collect(Collectors.joining());
        return new ShortRun(steps, "particles:\n" + balls + "effects: []\nrules:\n" + walls
                + "  - collisions: {radius: " + radius + ", restSpeed: 0, restitution: " + restitution + "}\n");
    }

    /** Counts impacts, adds up the impulse on the walls, and finds the largest change of momentum in an impact. */
    private static final class Watch implements Observer {
        private Vector3 before;
        private int impacts;
        private double onWalls;
        private double worst;

        static Watch on(ShortRun run) {
            Watch watch = new Watch();
            run.getSimulation().addObserver(watch);
            run.run();
            return watch;
        }

        private static Vector3 momentum(ParticleSystem system, double[] state) {
            Vector3 sum = Vector3.ZERO;
            for (int i = 0; i < system.getParticles().count(); i++) {
                sum = sum.plus(Vector3.at(state, 6 * i + 3).times(system.getParticles().mass(i)));
            }
            return sum;
        }

        @Override
        public void moved(Motion motion) {
            before = momentum(motion.getSystem(), motion.getEndState());
        }

        @Override
        public void changed(ParticleSystem system, Rule rule) {
            double change = momentum(system, system.getOwnState()).minus(before).norm1();
            boolean ofBalls = rule instanceof Collisions;
            impacts += ofBalls ? 1 : 0;
            worst = ofBalls ? Math.max(worst, change) : worst;
            onWalls += ofBalls ? 0 : change;
        }
    }

    /** Along the line of centres v' = v - (1 + e) m v_n, across it the impulse is at most mu times that. Off: 3e-16. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "1, 0.6, 0", "0.5, 0.6, 0", "0, 0.3, 0", "0.5, 0.6, 0.1", "0.5, 0.6, 9"})
    void twoBallsExchangeMomentum(double e, double offset, double mu) {
        ShortRun run = ShortRun.of("rk4 exact 0.01 2", String.format(Locale.ROOT, """
                particles:
                  - {id: a, position: [-2, %s, 0], velocity: [2, 0, 0]}
                  - {id: b, position: [0, 0, 0], mass: 3}
                effects: []
                rules:
                  - collisions: {radius: 0.5, restitution: %s, friction: %s, restSpeed: 0}
                """, offset, e, mu));
        Vector3 normal = new Vector3(Math.sqrt(1 - offset * offset), -offset, 0);
        Vector3 along = new Vector3(offset, normal.x(), 0);
        double push = 0.75 * (1 + e) * 2 * normal.x();
        Vector3 impulse = normal.times(push).plus(along.times(Math.min(mu * push, 0.75 * 2 * offset)));
        assertArrayEquals(new double[] {2 - impulse.x(), -impulse.y(), impulse.x() / 3, impulse.y() / 3},
                new double[] {run.at(3), run.at(4), run.at(9), run.at(10)}, 2e-15);
    }

    /** Measured over 2,716 impacts of 8 balls: momentum 4.4e-15 kg m/s, energy 3.6e-15 of it. */
    @Test
    void impactsKeepMomentumAndEnergy() {
        ShortRun run = gas("euler exact 0.05 55", 8, 0.2, 1);
        Watch watch = Watch.on(run);
        assertTrue(watch.impacts > 2_500, watch.impacts + " impacts");
        assertEquals(0, watch.worst, 4e-14);
        assertEquals(0, run.worstEnergy(), 3e-14);
    }

    /** Three balls meet pairwise, and come back if their velocities are reversed. */
    @Test
    void threeBallsComeBack() {
        String text = """
                particles:
                  - {id: a, position: [%s, %s, %s], velocity: [%s, %s, %s], mass: 2}
                  - {id: b, position: [%s, %s, %s], velocity: [%s, %s, %s]}
                  - {id: c, position: [%s, %s, %s], velocity: [%s, %s, %s], mass: 3}
                effects: []
                rules:
                  - collisions: {radius: 0.2, restitution: 1, restSpeed: 0}
                """;
        Object[] begin = {-1.0, 0.1, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.05, 0.0, 0.0, 0.0, 0.3, 0.8, 0.0, 0.0, -0.8, 0.02};
        ShortRun there = ShortRun.of("rk4 exact 0.01 2", text.formatted(begin));
        assertTrue(there.getSimulation().getEvents() >= 2, "each meets another");
        Object[] turned = IntStream.range(0, 18).mapToObj(k -> k % 6 < 3 ? there.at(k) : -there.at(k)).toArray();
        ShortRun back = ShortRun.of("rk4 exact 0.01 2", text.formatted(turned));
        double worst = 0;
        for (int k = 0; k < 18; k++) {
            worst = Math.max(worst, Math.abs((double) begin[k] - (k % 6 < 3 ? back.at(k) : -back.at(k))));
        }
        assertEquals(0, worst, 6e-14);
    }

    /**
     * Haff's law: an impact takes (1 - e^2) T from a gas of temperature T, so T falls as exp(-2/3 (1 - e^2) N/n) with
     * the number N of impacts.
     */
    @Test
    void aGasCoolsAsHaffSays() {
        ShortRun run = gas("euler exact 0.05 10", 64, 0.07, 0.95);
        Watch watch = Watch.on(run);
        double ratio = Math.log(run.getLedger().getStartEnergy() / run.getLedger().getEnergy())
                / (2.0 / 3 * (1 - 0.95 * 0.95) * watch.impacts / 64);
        assertEquals(1, ratio, 0.06);
    }

    /** p V = n k T, with the volume that centres can reach and the first virial coefficient, 1 + 4 phi. */
    @Test
    void aGasPressesOnItsWalls() {
        ShortRun run = gas("euler exact 0.05 20", 64, 0.04, 1);
        Watch watch = Watch.on(run);
        double side = 1 - 2 * 0.04;
        double phi = 64 * 4.0 / 3 * Math.PI * Math.pow(0.04 / side, 3);
        double ratio = watch.onWalls / 20 / 6 * side / (2.0 / 3 * run.getLedger().getStartEnergy() * (1 + 4 * phi));
        assertEquals(1, ratio, 0.06);
    }

    private static final String CRADLE = """
            particles:
            %s
            rods:
            %s
            rules:
              - collisions: {radius: 0.05, restitution: 1}
            """.formatted(IntStream.range(0, 5).mapToObj(i -> String.format(Locale.ROOT,
                    "  - {id: h%d, position: [%.1f, 0.5, 0], fixed: true}%n  - {id: b%d, position: [%.1f, %s, 0]}", i,
                    0.1 * i, i, i == 0 ? -0.3 : 0.1 * i, i == 0 ? 0.1 : 0)).collect(Collectors.joining("\n")),
            IntStream.range(0, 5).mapToObj(i -> "  - {from: h" + i + ", to: b" + i + "}").collect(Collectors
                    .joining("\n")));

    /** Balls that touch: one comes in and one goes out. After 1.5 s the first ball is on its way back up. */
    @ParameterizedTest
    @MethodSource("solvers")
    void theCradlePassesAnImpactOn(SolverInfo solver) {
        ShortRun run = ShortRun.of(solver.name() + " exact 0.002 1.5", CRADLE);
        double[] limits = {0, 0.05, 1e-5, 3e-8};        // by order; measured: 9e-3, 3e-6, 2e-9
        double limit = limits[Math.min(3, solver.order())];
        assertEquals(-0.29545715, run.at(6), limit);
        for (int i = 1; i < 5; i++) {
            assertEquals(0.1 * i, run.at(12 * i + 6), limit, "ball " + i + " hangs still");
        }
        double[] gains = {0, 0.05, 2e-4, 1e-6};         // measured: 2e-2, 6e-5, 6e-8
        assertEquals(0, run.work("collisions"), gains[Math.min(3, solver.order())], "energy of collisions");
    }

    /** Three balls in a groove of 90 degrees: the lower one presses with sqrt(2) m g on each side. */
    @ParameterizedTest
    @MethodSource("solvers")
    void threeBallsInAGroove(SolverInfo solver) {
        ShortRun run = ShortRun.of(solver.name() + " exact 0.01 0.5", """
                particles:
                  - {id: a, position: [0, 0.282842712474619, 0]}
                  - {id: b, position: [-0.282842712474619, 0.565685424949238, 0]}
                  - {id: c, position: [0.282842712474619, 0.565685424949238, 0]}
                rules:
                  - collisions: {radius: 0.2}
                  - plane: {normal: [1, 1, 0]}
                  - plane: {normal: [-1, 1, 0]}
                """);
        double[] forces = {pressure(run, 0, 0), pressure(run, 1, 0), pressure(run, 0, 1), pressure(run, 1, 2),
            leastPush(run)};
        double side = G / Math.sqrt(2);
        assertArrayEquals(new double[] {2 * side, 2 * side, side, side, side}, forces, 5e-12);
        assertEquals(0.282842712474619, run.at(1), 1e-14, "it keeps still");
    }

    /** A rough groove holds a ball back along its bottom line only: round-off is no direction across it. */
    @Test
    void roundOffIsNoDirectionOfSliding() {
        ShortRun run = new ShortRun("rk4 exact 0.01 1", """
                particles:
                  - {id: a, position: [0, 0.282842712474619, 0]}
                  - {id: b, position: [0, 0.682842712474619, 0]}
                rules:
                  - collisions: {radius: 0.2}
                  - plane: {normal: [1, 1, 0], friction: {law: coulomb, coefficient: 0.6}}
                  - plane: {normal: [-1, 1, 0], friction: {law: coulomb, coefficient: 0.6}}
                """);
        run.getSimulation().start();
        run.contacts().getContacts().getModes().setWhereTouching(0, Mode.SLIDING);
        double[] state = run.getState();
        new Vector3(0.02, -0.02, 0).put(state, 3);
        run.contacts().getContacts().beginStep();
        new Vector3(-1.7e-18, -1.7e-18, 0).put(state, 3);
        assertArrayEquals(new double[] {Math.sqrt(2) * G, Math.sqrt(2) * G}, new double[] {pressure(run, 0, 0),
            pressure(run, 1, 0)}, 1e-13);
    }

    private static double pressure(ShortRun run, int surface, int particle) {
        return run.contacts().getQueries().pressure(surface, particle, run.getState(), run.effects());
    }

    private static double leastPush(ShortRun run) {
        return run.rods().balls().leastPush(run.getState(), 0, run.effects());
    }

    /** A pyramid of four: the upper ball pushes each of the three below with m g/3 over the cosine of the slope. */
    @Test
    void aPyramidOfFourKeepsStill() {
        double out = 0.4 / Math.sqrt(3);
        double up = Math.sqrt(0.16 - out * out);
        StringBuilder balls = new StringBuilder("particles:\n  - {id: top, position: [0, " + (0.2 + up) + ", 0]}\n");
        StringBuilder walls = new StringBuilder("rules:\n  - collisions: {radius: 0.2}\n  - ground\n");
        for (int k = 0; k < 3; k++) {
            double x = Math.cos(2 * Math.PI * k / 3);
            double z = Math.sin(2 * Math.PI * k / 3);
            balls.append("  - {id: b" + k + ", position: [" + out * x + ", 0.2, " + out * z + "]}\n");
            walls.append("  - plane: {point: [" + (out + 0.2) * x + ", 0, " + (out + 0.2) * z + "], normal: [" + -x
                    + ", 0, " + -z + "]}\n");
        }
        ShortRun run = ShortRun.of("rk4 exact 0.01 1", balls.toString() + walls);
        double push = G / 3 * 0.4 / up;
        assertArrayEquals(new double[] {4 * G / 3, push * out / 0.4}, new double[] {pressure(run, 0, 1),
            pressure(run, 1, 1)}, 2e-13);
        assertEquals(0.2 + up, run.at(1), 1e-14, "it keeps still");
    }

    /** Scenes in which hard balls meet everything else. */
    private static final List<String> CROSSINGS = List.of("""
            particles:                                  # a piston pushes a row of balls over rough ground
              - {id: p, position: [-1, 0.1, 0], fixed: true}
              - {id: a, position: [0, 0.1, 0]}
              - {id: b, position: [0.3, 0.1, 0], mass: 2}
              - {id: c, position: [0.6, 0.1, 0]}
            springs:
              - {from: b, to: c, stiffness: 500, damping: 1}
            rules:
              - glide: {particle: p, to: [1, 0.1, 0], duration: 2}
              - collisions: {radius: 0.1, restitution: 0.3, friction: 0.2}
              - ground: {friction: {law: coulomb, coefficient: 0.4}}
            """, """
            particles:                                  # beads on a wire, drawn together by a spring
              - {id: a, position: [0, 0, 0]}
              - {id: b, position: [0.5, 0, 0], mass: 2}
              - {id: c, position: [1, 0, 0]}
            wires:
              - line: {bead: a, direction: [1, 0, 0]}
              - line: {bead: b, direction: [1, 0, 0]}
              - line: {bead: c, direction: [1, 0, 0]}
            springs:
              - {from: a, to: c, stiffness: 30, restLength: 0.1}
            rules:
              - collisions: {radius: 0.1, restitution: 0.8, friction: 0.2}
            """, """
            particles:                                  # a triangle of rods falls on a post and on a loose ball
              - {id: a, position: [-0.2, 1, 0]}
              - {id: b, position: [0.25, 1, 0]}
              - {id: c, position: [0, 1.4, 0]}
              - {id: post, position: [0, 0.3, 0], fixed: true, radius: 0.2}
              - {id: loose, position: [0.3, 0.1, 0.02], radius: 0.1}
            rods:
              - {from: a, to: b}
              - {from: b, to: c}
              - {from: a, to: c}
            rules:
              - collisions: {radius: 0.05, restitution: 0.4, friction: 0.3}
              - ground: {friction: {law: coulomb, coefficient: 0.4, impacts: false}}
            """, """
            particles:                                  # balls of three sizes in a bowl
              - {id: a, position: [-0.5, 0.2, 0], radius: 0.2}
              - {id: b, position: [0.3, 0.1, 0.1]}
              - {id: c, position: [0.1, 0.5, 0], mass: 3}
            rules:
              - collisions: {radius: 0.1}
              - sphere: {centre: [0, 0.5, 0], radius: 1, hollow: true}
            """, """
            particles:                                  # a shaken anchor throws two balls up
              - {id: p, position: [0, 0, 0], fixed: true}
              - {id: a, position: [0, 0.5, 0]}
              - {id: b, position: [0, 0.8, 0]}
            rules:
              - shake: {particle: p, amplitude: [0, 0.1, 0], period: 0.5}
              - collisions: {radius: 0.1, restitution: 0.8}
            """, """
            particles:                                  # a ball falls on a column
              - {id: a, position: [0, 0.1, 0]}
              - {id: b, position: [0, 0.3, 0]}
              - {id: c, position: [0, 0.5, 0]}
              - {id: d, position: [0, 2, 0]}
            rules:
              - collisions: {radius: 0.1}
              - ground
            """);

    static List<Object[]> crossings() {
        return SolverCatalog.all().stream().flatMap(solver -> CROSSINGS.stream().map(text -> new Object[] {solver,
            text})).toList();
    }

    /** No solver lets contacts and rods err by more than its order, or gains energy in impacts that are not driven. */
    @ParameterizedTest
    @MethodSource("crossings")
    void ballsStayApart(SolverInfo solver, String text) {
        ShortRun run = new ShortRun(solver.name() + " exact 0.005 1.5", text);
        double[] deepest = new double[1];
        RigidConstraints rods = run.rods();
        run.getSimulation().addObserver(onMove(motion -> {
            deepest[0] = Math.max(deepest[0], rods.getViolation(motion.getEndState(), 0).part());
        }));
        run.run();
        double[] limits = {0, 0.03, 3e-4, 3e-4};        // by order; measured: 1.2e-2, 6e-5, 6e-5
        assertEquals(0, deepest[0], limits[Math.min(3, solver.order())]);
        double[] errors = {0, 5, 0.03, 5e-4};           // J of some 20 J; measured: 4, 2e-2, 2e-4
        assertEquals(0, run.getNumericalError(), errors[Math.min(3, solver.order())]);
        assertTrue(run.work("collisions") < 0 || text.contains("period") || text.contains("duration"), "a loss");
    }

    /**
     * Nine balls, or 16, fall into a box: dependent contacts open, close, stick and slide, until all balls lie still.
     * In a gap of round-off size a ball may not bounce between two others for ever, round-off is no direction of
     * sliding, and five balls fit exactly into a width of 1 m. In that of 1.1 m, a ball that had parted slowly from
     * another one once drifted 2 mm off the ground that it touched. Of 16, one that stuck has stopped others, and
     * friction has no direction any more.
     */
    @ParameterizedTest
    @CsvSource({"3, 0.5, 0", "3, 0.5, 0.3", "3, 0.47, 0", "3, 0.47, 0.3", "3, 0.53, 0.3", "3, 0.55, 0.3",
        "4, 0.7, 0.3"})
    void aBoxOfBallsComesToRest(int side, double half, double friction) {
        String law = "restitution: 0.3, friction: {law: coulomb, coefficient: " + friction + "}";
        ShortRun run = ShortRun.of("rk4 exact 0.005 2", """
                shapes:
                  - cloth: {id: ball, corner: [%s, %s, 0], across: [%s, 0.06, 0], down: [0.05, %s, 0],
                            columns: %d, rows: %5$d, mass: 1, surface: false}
                rules:
                  - collisions: {radius: 0.1, restitution: 0.3, friction: %6$s}
                  - plane: {point: [-%7$s, 0, 0], normal: [1, 0, 0], %8$s}
                  - plane: {point: [%7$s, 0, 0], normal: [-1, 0, 0], %8$s}
                  - ground: {%8$s}
                """.formatted(-0.14 * (side - 1), 0.3 + 0.4 * side, 0.3 * (side - 1), -0.35 * (side - 1), side,
                friction, half, law));
        double fastest = 0;
        for (int i = 0; i < side * side; i++) {
            fastest = Math.max(fastest, Vector3.at(run.getState(), 6 * i + 3).length());
        }
        assertEquals(0, fastest, 0.05);
        assertEquals(0, run.getSimulation().getViolation().part(), 3e-5);   // measured: 2e-12, rough 3e-6
    }

    /** Contacts that cannot all have their exact distance are no matter of the projection onto rods. */
    @Test
    void projectionKeepsRodsWherePackedBallsAreOffByRoundOff() {
        ShortRun run = ShortRun.of("rk4 exact 0.01 0.1", """
                particles:
                  - {id: left, position: [-0.2000000009, 0, 0], fixed: true}
                  - {id: ball, position: [0, 0, 0]}
                  - {id: right, position: [0.2000000009, 0, 0], fixed: true}
                  - {id: other, position: [0, 0.5, 0]}
                rods:
                  - {from: ball, to: other}
                constraints: {projection: true}
                rules:
                  - collisions: {radius: 0.1}
                effects: []
                """);
        assertEquals(0.5, run.distance(1, 3), 1e-15);
    }

    /** Two balls that a rule throws onto each other between the steps overlap at the end, which the run tells. */
    @Test
    void anOverlapIsToldAtTheEnd() {
        ShortRun run = new ShortRun("rk4 exact 0.01 0.1", """
                particles:
                  - {id: a, position: [0, 0, 0]}
                  - {id: b, position: [1, 0, 0]}
                rules:
                  - collisions: {radius: 0.1}
                effects: []
                """);
        run.getSimulation().addRule(afterStep(system -> {
            system.getOwnState()[0] = 0.85;
            return true;
        }));
        SimulationException e = assertThrows(SimulationException.class, run::run);
        assertStarts(e.getMessage(), "'a' and 'b' overlap by 0.05 m");
    }

    /** A contact ends with the death of a ball, and rods stay rods. */
    @Test
    void aDeathEndsContacts() {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < 5; i++) {
            system.addParticle("p" + i, 1, new Vector3(i, 0, 0), Vector3.ZERO, false);
        }
        RigidConstraints rods = new RigidConstraints(system, 0);
        rods.addRod(0, 1, 1);
        rods.balls().touch(1, 2, 1, new Bounce(1, 0, 0));
        rods.balls().touch(3, 4, 1, new Bounce(1, 0, 0));
        rods.reindex(new int[] {0, 1, 2, -1, 3});
        assertEquals(1, rods.springCount());
        assertEquals(1, rods.balls().count());
    }

    /** An impact on one ball leaves its neighbour where static friction holds it on the slope. */
    @Test
    void anImpactLeavesStuckNeighboursWhereTheyAre() {
        ShortRun run = ShortRun.of("rk4 exact 0.005 0.6", """
                particles:
                  - {id: a, position: [0, 0.1, 0]}
                  - {id: b, position: [0, 0.1, 0.2]}
                  - {id: c, position: [0, 1, 0.19], velocity: [0, -5, 0]}
                rules:
                  - ground: {friction: {law: coulomb, coefficient: 0.3, static: 0.6, impacts: false}}
                  - collisions: {radius: 0.1}
                effects: [gravity: {acceleration: [4, -9.81, 0]}]
                """);
        assertTrue(Math.abs(run.at(6)) > 1e-3, "the third hits the second");
        assertEquals(0, run.at(0));
    }

    /** Static friction holds two balls on a slope; a light ball pushes one onto the other, and it is held again. */
    @Test
    void slowBallsStickAgainAfterAnImpact() {
        ShortRun run = ShortRun.of("rk4 exact 0.005 0.15", """
                particles:
                  - {id: a, position: [0.2, 0.1, 0]}
                  - {id: b, position: [0, 0.1, 0]}
                  - {id: c, position: [-0.6, 0.1, 0], velocity: [4, 0.3, 0], mass: 0.001}
                rules:
                  - ground: {friction: {law: coulomb, coefficient: 0.3, static: 0.6}}
                  - collisions: {radius: 0.1, restitution: 1}
                effects: [gravity: {acceleration: [4, -9.81, 0]}]
                """);
        assertTrue(run.at(15) < 0, "the light ball has bounced back");
        assertTrue(run.isHeld(0) && run.isHeld(1), "both are held");
    }

    /** What cannot be is refused in one line. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "effects: []; rules: [collisions: {radius: 0.6}] | 'a' and 'b' overlap by 0.2 m at the start",
        "effects: [repulsion: {radius: 1, stiffness: 1}]; rules: [collisions: {radius: 0.1}] | cannot be combined",
        "effects: []; rules: [collisions: {radius: 0.1}, samples: {farthest: 1, lightest: 1}] | merge",
        "effects: []; rules: [collisions: {radius: 0.1}, collisions: {radius: 0.1}] | is already named",
        "effects: []; rules: [collisions: {radius: 0.5}, ground: {height: -0.25}] | 'a', a ball of radius 0.5 m,"
                + " begins 0.25 m inside the 'ground'"})
    void mistakesAreNamed(String more, String message) {
        InvalidInputException e = assertThrows(InvalidInputException.class, () -> new ShortRun("rk4 exact 0.01 1", """
                particles:
                  - {id: a, position: [0, 0, 0]}
                  - {id: b, position: [1, 0, 0]}
                """ + more.replace("; ", "\n")));
        assertHas(e.getMessage(), message);
    }
}
