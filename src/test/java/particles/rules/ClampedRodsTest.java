package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;

import deSolvers.RK4Solver;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Simulation;
import particles.effects.Gravity;
import particles.energy.EnergyLedger;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/** Rod linkages that fall onto rough ground and come to rest, with clamped impacts. */
class ClampedRodsTest {
    /** Positions of particles of 1 kg, their common velocity, and rods between pairs. */
    private record Shape(double[][] places, Vector3 velocity, int[][] rods) {
    }

    private static final Shape THROWN_TRIANGLE = new Shape(new double[][] {{0, 0.5, 0}, {1, 0.7, 0}, {0.4, 1.4, 0.3}},
            new Vector3(1, 0, 0.3), new int[][] {{0, 1}, {1, 2}, {0, 2}});
    private static final Shape TOPPLING_TRIANGLE = new Shape(new double[][] {{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0.1}},
            Vector3.ZERO, new int[][] {{0, 1}, {1, 2}, {0, 2}});
    private static final Shape CHAIN = new Shape(new double[][] {{0, 0.3, 0}, {0.5, 0.4, 0}, {1, 0.6, 0.1},
            {1.4, 0.9, 0}},
            Vector3.ZERO, new int[][] {{0, 1}, {1, 2}, {2, 3}});

    /** Records the largest error of a rod's length and the highest energy at the end of a step. */
    private static final class Watch implements Observer {
        private final RigidConstraints rods;
        private double worstLength;
        private double mostEnergy;

        Watch(RigidConstraints rods) {
            this.rods = rods;
        }

        @Override
        public void moved(Motion motion) {
            ParticleSystem system = motion.getSystem();
            double[] s = system.getOwnState();
            for (int r = 0; r < rods.springCount(); r++) {
                int a = 6 * rods.from(r);
                int b = 6 * rods.to(r);
                double length = new Vector3(s[b] - s[a], s[b + 1] - s[a + 1], s[b + 2] - s[a + 2]).length();
                worstLength = Math.max(worstLength, Math.abs(length - rods.restLength(r)));
            }
            mostEnergy = Math.max(mostEnergy, system.getEnergy(s, motion.getEndTime()));
        }
    }

    /**
     * All particles end on the ground and stick there. The last one is moved onto the ground and the rods are corrected
     * before friction holds it; otherwise the rods of the chain could not keep their lengths.
     */
    @ParameterizedTest
    @CsvSource({"thrown, 0.3, 2", "toppling, 0.5, 1", "chain, 0.3, 1.6", "chain, 0.8, 1.6"})
    void rodsComeToRestOnRoughGround(String name, double mu, double duration) {
        Shape shape = name.equals("thrown") ? THROWN_TRIANGLE : name.equals("chain") ? CHAIN : TOPPLING_TRIANGLE;
        ParticleSystem system = new ParticleSystem();
        for (double[] place : shape.places()) {
            system.addParticle("p" + system.getParticles().count(), 1, new Vector3(place[0], place[1], place[2]),
                    shape.velocity(), false);
        }
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        RestingContacts contacts = new RestingContacts(system, List.of(new ContactSurface("ground",
                Plane.ground(0), name.equals("toppling") ? 0 : 0.3,
                new Friction(Friction.Law.COULOMB, mu, mu, 1e-2), 1e-2)));
        RigidConstraints rods = new RigidConstraints(system, 5);
        for (int[] rod : shape.rods()) {
            double[] a = shape.places()[rod[0]];
            double[] b = shape.places()[rod[1]];
            rods.addRod(rod[0], rod[1], new Vector3(b[0] - a[0], b[1] - a[1], b[2] - a[2]).length());
        }
        rods.solveWith(contacts);
        system.addReaction(contacts);
        system.addReaction(rods);
        EnergyLedger ledger = new EnergyLedger();
        Watch watch = new Watch(rods);
        Simulation simulation = new Simulation(system, RK4Solver::new, 0.005, duration);
        simulation.addRule(new ClampedImpacts(contacts));
        simulation.addObserver(ledger);
        simulation.addObserver(watch);
        simulation.run();
        for (int i = 0; i < system.getParticles().count(); i++) {
            assertTrue(contacts.getModes().isSticking(i), "particle " + i + " at rest");
            assertEquals(0, system.getOwnState()[6 * i + 1], 1e-12, "on the ground");
            assertEquals(0, Impacts.velocity(system.getOwnState(), i).length(), 1e-12, "at rest");
        }
        assertEquals(0, watch.worstLength, 1e-7, "measured: 3e-8 at most");
        assertEquals(0, Math.max(0, watch.mostEnergy - ledger.getStartEnergy()), 1e-3,
                "clamping lifts particles; measured: 2.4e-4 J for the toppling triangle, for the others 1e-13");
        assertTrue(ledger.getWork().get("contact") < 0 && ledger.getWork().get("impacts") < -5,
                ledger.getWork().toString());
    }
}
