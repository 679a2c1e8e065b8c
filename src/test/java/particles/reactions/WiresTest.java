package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.addGravity;
import static particles.Systems.afterStep;
import static particles.Systems.oneParticle;

import deSolvers.RK4Solver;
import deSolvers.problems.Steps;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.law.Vector3;
import particles.reactions.Curve.Profile;
import particles.scene.ShortRun;

/** Beads on wires against closed forms, and the curves' derivatives against differences. */
class WiresTest {
    private static final double G = 9.81;
    private static final Vector3 X = new Vector3(1, 0, 0);

    private static ParticleSystem bead(Vector3 position, Vector3 velocity, Curve wire) {
        ParticleSystem system = oneParticle(position, velocity);
        addGravity(system);
        RigidConstraints constraints = new RigidConstraints(system, 5);
        constraints.addBead(0, wire);
        system.addReaction(constraints);
        return system;
    }

    /** Runs a bead on a wire by rk4. */
    private static ShortRun run(String steps, String bead, String wire) {
        return ShortRun.of("rk4 clamp " + steps, "particles: [{id: bead, %s}]\nwires: [%s]".formatted(bead, wire));
    }

    static Stream<Curve> curves() {
        return Stream.of(Curve.line(new Vector3(1, 2, 3), new Vector3(1, -1, 0.5)),
                Curve.circle(new Vector3(0.3, 0, 1), new Vector3(1, 2, 3), 0.7),
                Curve.graph(new Vector3(0, 1, 0), Profile.parabola(1.5)),
                Curve.graph(new Vector3(0.1, 0.2, 0.3), Profile.sine(0.4, 2)));
    }

    /**
     * Gradients and bends are first and second derivatives of the values along any motion. Measured: 1.4e-8, 9.2e-8.
     */
    @ParameterizedTest
    @MethodSource("curves")
    void gradientsAndBendsMatchFiniteDifferences(Curve curve) {
        Random random = new Random(7);
        double h = 1e-4;
        for (int k = 0; k < 20; k++) {
            double[] state = random.doubles(6, -1, 1).toArray();
            Vector3 x = Vector3.at(state, 0);
            Vector3 v = Vector3.at(state, 3);
            for (Curve.Surface surface : curve.surfaces()) {
                double before = surface.value(x.minus(v.times(h)));
                double after = surface.value(x.plus(v.times(h)));
                assertEquals((after - before) / (2 * h), surface.gradient(x).dot(v), 1e-7);
                assertEquals((after - 2 * surface.value(x) + before) / (h * h), surface.bend(x, v), 9e-7);
            }
        }
    }

    /** Down a straight wire of slope a: s = g sin(a) t&sup2;/2, along it. */
    @Test
    void aBeadOnAStraightWireSlidesLikeOnASlope() {
        ShortRun run = run("0.01 1", "position: [1, 1, 1]", "line: {bead: bead, direction: [3, -4, 0]}");
        double way = G * 0.8 / 2;
        assertEquals(1 + 0.6 * way, run.at(0), 2e-14);      // measured 2.2e-15
        assertEquals(1 - 0.8 * way, run.at(1), 2e-14);      // measured 2.7e-15
        assertEquals(1, run.at(2));
    }

    /** A bead on a ring with any axis moves like a pendulum on a rod in a plane. Measured: 0, by luck. */
    @Test
    void aBeadOnARingMovesLikeAPendulum() {
        ShortRun ring = run("0.01 10", "position: [0.8, -0.6, 0]",
                "circle: {bead: bead, centre: [0, 0, 0], radius: 1}");
        ShortRun rod = ShortRun.of("rk4 clamp 0.01 10", """
                particles: [{id: bob, position: [0.8, -0.6, 0]}, {id: nail, position: [0, 0, 0], fixed: true}]
                rods: [{from: nail, to: bob}]
                """);
        for (int k = 0; k < 6; k++) {
            assertEquals(rod.at(k), ring.at(k), 1e-13);
        }
    }

    /**
     * Released at height h in a valley, a bead has speed sqrt(2 g h) and the normal force m (g + f'' v&sup2;) at the
     * bottom.
     */
    @Test
    void aBeadAtTheBottomOfAValleyHasItsSpeedAndNormalForce() {
        for (Profile profile : new Profile[] {Profile.parabola(2), Profile.sine(-0.5, Math.PI)}) {
            double start = Math.PI / 4;
            boolean parabola = profile.bend().applyAsDouble(0) == 2;
            double bottom = parabola ? 0 : Math.PI / 4;
            double from = parabola ? -start : 0.1;
            ParticleSystem system = bead(new Vector3(from, profile.value().applyAsDouble(from), 0), Vector3.ZERO,
                    Curve.graph(Vector3.ZERO, profile));
            RK4Solver solver = new RK4Solver();
            while (system.getOwnState()[0] < bottom) {
                solver.stepState(system, 0.001);
            }
            for (int k = 0; k < 5; k++) {
                solver.stepState(system, (bottom - system.getOwnState()[0]) / system.getOwnState()[3]);
            }
            double[] state = system.getOwnState();
            double square = 2 * G * (profile.value().applyAsDouble(from) - profile.value().applyAsDouble(bottom));
            assertEquals(Math.sqrt(square), state[3], 2e-10);           // measured 2.7e-11
            assertEquals(profile.value().applyAsDouble(bottom), state[1], 3e-11);    // measured 3.6e-12
            double[] dSdt = new double[6];
            system.getStateDerivative(dSdt);
            // measured 6.6e-10
            assertEquals(profile.bend().applyAsDouble(bottom) * square, dSdt[4], 5e-9, "normal force minus weight");
        }
    }

    /** Ten minutes on a sine wire: 1e-6 by feedback, 1e-12 by projection. Measured: 5.7e-7, 6e-16. */
    @Tag("slow")
    @Test
    void aBeadStaysOnItsWire() {
        for (boolean projection : new boolean[] {false, true}) {
            ShortRun run = new ShortRun("rk4 clamp 0.01 " + (projection ? 60 : 600), """
                    particles: [{id: bead, position: [0.6, %s, 0]}]
                    wires: [sine: {bead: bead, amplitude: 0.3, wavelength: 2}]
                    constraints: {projection: %s}
                    """.formatted(0.3 * Math.sin(0.6 * Math.PI), projection));
            double[] worst = {0};
            run.getSimulation().addRule(afterStep(s -> {
                worst[0] = Math.max(worst[0],
                        Math.abs(s.getOwnState()[1] - 0.3 * Math.sin(Math.PI * s.getOwnState()[0])));
                return false;
            }));
            run.run();
            assertTrue(worst[0] <= (projection ? 3e-15 : 1e-6), "off by " + worst[0]);
        }
    }

    @Test
    void invalidWiresAreRefused() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("nail", 1, Vector3.ZERO, Vector3.ZERO, true);
        Steps.assertRefused(() -> Curve.circle(Vector3.ZERO, X, 0),
                () -> Profile.sine(1, 0), () -> Profile.sine(Double.NaN, 1),
                () -> new RigidConstraints(system, 5).addBead(0, Curve.line(Vector3.ZERO, X)));
    }

    /**
     * A projection without a solution fails clearly: a rod of 1 m whose ends are held 3 m apart by a ring and a nail.
     */
    @Test
    void projectionWithoutASolutionIsAClearError() {
        ParticleSystem system = bead(new Vector3(1, 0, 0), Vector3.ZERO,
                Curve.circle(Vector3.ZERO, new Vector3(0, 0, 1), 1));
        system.addParticle("nail", 1, new Vector3(5, 0, 0), Vector3.ZERO, true);
        RigidConstraints constraints = (RigidConstraints) system.getReactions().get(0);
        constraints.addRod(0, 1, 1);
        String message = assertThrows(SimulationException.class, () -> constraints.project(system.getOwnState(),
                0)).getMessage();
        assertEquals("no positions satisfy the rods and wires at t = 0.0 s: after 30 iterations the relative error of"
                + " their lengths is still 0.75", message);
    }
}
