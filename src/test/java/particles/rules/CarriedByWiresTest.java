package particles.rules;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Steps;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import particles.SimulationException;
import particles.scene.ShortRun;

/** Where rods and wires keep a particle from moving across a surface, the surface exerts no force, by every solver. */
class CarriedByWiresTest {
    private static final String LINE = "line: {bead: bead, direction: [1, 0, 0]}";
    private static final String PARABOLA = "parabola: {bead: bead, origin: [0, 0, 0], curvature: 2}";
    private static final String GROUND = "ground: {friction: {law: coulomb, coefficient: 0.5}}";

    private static Stream<Arguments> solversAndImpacts() {
        return SolverCatalog.names().stream().flatMap(solver -> Stream.of("clamp", "exact")
                .map(impact -> Arguments.of(solver, impact)));
    }

    private static ShortRun bead(String solver, String impact, String wire, String more) {
        return new ShortRun(solver + " " + impact + " 0.01 0.5", """
                particles:
                  - {id: pivot, position: [-1, 0, 0], fixed: true}
                  - {id: bead, position: [0, 0, 0]}
                wires: [%s]
                effects: [gravity: {acceleration: [1, -10, 0]}]
                %s
                """.formatted(wire, more));
    }

    private static double[] end(String solver, String impact, String wire, String rule) {
        return bead(solver, impact, wire, "rules: [" + rule + "]").run().getState();
    }

    /** On rough ground, a bead moves bit for bit as 1 m above it; on the line that is x = t&sup2;/2. */
    @ParameterizedTest
    @MethodSource("solversAndImpacts")
    void aBeadOnAWireAlongTheGroundDoesNotFeelTheGround(String solver, String impact) {
        for (String wire : List.of(LINE, PARABOLA)) {
            assertArrayEquals(end(solver, impact, wire, GROUND.replace("{f", "{height: -1, f")),
                    end(solver, impact, wire, GROUND));
        }
        assertEquals(0.5, end(solver, impact, LINE, GROUND)[9], 1e-13, "the speed at t = 0.5 s");
    }

    /** A rod pushes a bead along its wire, at last into a wall: nothing can give way. */
    @ParameterizedTest
    @MethodSource("solversAndImpacts")
    void aBeadThatIsDrivenIntoAWallEndsTheRun(String solver, String impact) {
        ShortRun run = bead(solver, impact, LINE, """
                rods: [{from: pivot, to: bead}]
                rules:
                  - glide: {particle: pivot, to: [-0.5, 0, 0], duration: 0.5}
                  - plane: {point: [0.25, 0, 0], normal: [-1, 0, 0]}
                """);
        SimulationException end = Steps.assertFails(SimulationException.class, "no room left between",
                run::run);
        assertEquals(0.25, end.getTime(), 0.011, "half way of the glide is at half its time");
    }
}
