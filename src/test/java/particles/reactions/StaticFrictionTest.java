package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.addGravity;
import static particles.Systems.springs;

import deSolvers.RK4Solver;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.ParticleSystem;
import particles.Systems;
import particles.law.Obstacle;
import particles.law.Plane;
import particles.law.Vector3;
import particles.rules.ClampedImpacts;
import particles.scene.ShortRun;

/** The cost of deciding whether friction holds a linkage, counted in calls of the ground's normal. */
class StaticFrictionTest {
    private static final int STEPS = 10;

    private static long looksInAStep(int rods) {
        long[] looks = {0};
        Obstacle ground = (Obstacle) Proxy.newProxyInstance(Obstacle.class.getClassLoader(),
                new Class<?>[] {Obstacle.class}, (proxy, method, values) -> {
                    looks[0] += method.getName().equals("normal") ? 1 : 0;
                    return method.invoke(Plane.ground(0), values);
                });
        ParticleSystem system = new ParticleSystem();
        RestingContacts contacts = new RestingContacts(system, List.of(new ContactSurface("ground", ground, 0,
                new ContactSurface.Friction(ContactSurface.Friction.Law.COULOMB, 0.5, 0.5, 0), 1e-6)));
        RigidConstraints constraints = new RigidConstraints(contacts, 5);
        for (int i = 0; i <= rods; i++) {
            system.addParticle("p" + i, 1, new Vector3(0.5 * i, 0, 0), Vector3.ZERO, false);
            if (i > 0) {
                constraints.addRod(i - 1, i, 0.5);
            }
        }
        addGravity(system);
        system.addReaction(contacts);
        system.addReaction(constraints);
        Systems.run(system, new RK4Solver(), 1.0 / 256, STEPS / 256.0, new ClampedImpacts(contacts));
        for (int i = 0; i <= rods; i++) {
            assertTrue(contacts.getContacts().getModes().isSticking(i), "particle " + i);
            assertEquals(0.5 * i, system.getOwnState()[6 * i]);
        }
        return looks[0] / STEPS;
    }

    /**
     * Each particle checks all ends once. Measured 34, 100 and 340 calls for 4, 8 and 16 rods; a search for loads takes
     * 206,806 for 4 and 1,340,075 for 8.
     */
    @Test
    void aChainAtRestNeedsNoSearchForLoads() {
        for (int rods : new int[] {4, 8, 16}) {
            long looks = looksInAStep(rods);
            assertTrue(looks < 2L * (rods + 1) * (rods + 1), rods + " rods: " + looks);
        }
    }

    /**
     * A spring pulls the end of a chain of 50 rods along rough ground: it holds up to mu m g for each particle. To pass
     * the load on from rod to rod takes thousands of turns: once, 45 of the 51 particles slipped at 0.9 of the limit.
     * With a second spring across the chain, its other end slips and all that do not need its friction hold. The
     * same is true of a very light end beside heavy particles.
     */
    @ParameterizedTest
    @CsvSource({"0.9, 0.01, 1, 51", "0.9999, 0.01, 1, 51", "1.01, 0.01, 1, 0", "0.98, 200, 1, 50",
        "0.9999, 1e-9, 1e-6, 51", "0.98, 5e-4, 1e-6, 50"})
    void aLongChainHoldsTheSumOfItsFriction(double part, double across, double mass, int held) {
        int n = 50;
        double limit = 0.5 * ShortRun.G;
        ShortRun run = ShortRun.of("rk4 clamp 0.000001 0.000002", "particles:\n"
                + "  - {id: hand, position: [%s, 0, 0], fixed: true}\n".formatted(0.1 * n + 1)
                + "  - {id: side, position: [0, 0, 1], fixed: true}\n"
                + IntStream.rangeClosed(0, n).mapToObj(i -> "  - {id: p%d, position: [%s, 0, 0], mass: %s}%n"
                        .formatted(i, 0.1 * i, i == 0 ? mass : 1)).collect(Collectors.joining())
                + "springs:\n  - {from: p%d, to: hand, stiffness: %s, restLength: 0, damping: 0}\n".formatted(n,
                        part * limit * (n + mass))
                + "  - {from: p0, to: side, stiffness: %s, restLength: 0, damping: 0}\n".formatted(across * limit)
                + "rods:\n" + IntStream.range(0, n).mapToObj(i -> "  - {from: p%d, to: p%d}%n".formatted(i, i + 1))
                        .collect(Collectors.joining())
                + "rules:\n  - ground: {restitution: 0, friction: {law: coulomb, coefficient: 0.5}}\n");
        assertEquals(held, IntStream.rangeClosed(2, n + 2).filter(run::isHeld).count());
    }
}
