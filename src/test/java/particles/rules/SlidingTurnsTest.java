package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;
import static particles.Systems.entry;
import static particles.Systems.oneParticle;

import deSolvers.RK4Solver;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.Simulation;
import particles.effects.Gravity;
import particles.energy.EnergyLedger;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/**
 * A particle that slides up a slope of 45 degrees, too steep for friction to hold it, turns round and slides down
 * again.
 */
class SlidingTurnsTest {
    private static final double SLOPE = Math.sqrt(0.5);
    private static final double MU = 0.2;
    private final EnergyLedger ledger = new EnergyLedger();
    private long events;

    /** Runs a slide from the origin with given speeds up and across the slope. */
    private ParticleSystem slide(double up, double along, double threshold, double deltaT, double duration) {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(up * SLOPE, up * SLOPE, along));
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        RestingContacts contacts = new RestingContacts(system, List.of(new ContactSurface("slope",
                new Plane(Vector3.ZERO, new Vector3(-SLOPE, SLOPE, 0)), 0.5,
                new Friction(Friction.Law.COULOMB, MU, MU, threshold), 1e-6)));
        system.addReaction(contacts);
        Simulation simulation = new Simulation(system, RK4Solver::new, deltaT, duration);
        simulation.addRule(new ExactImpacts(contacts));
        simulation.addObserver(ledger);
        simulation.run();
        events = simulation.getEvents();
        return system;
    }

    /**
     * Straight up, it stops after v/(g (sin + mu cos)) and slides down with g (sin - mu cos), for any threshold below
     * which friction would hold it on a gentler slope: one event for the threshold, one for the reversal.
     */
    @Test
    void aSlideStraightUpReversesOnce() {
        double g = 9.81 * SLOPE;
        double turn = 1 / (g * (1 + MU));
        for (double threshold : new double[] {0, 0.01, 0.3}) {
            ParticleSystem system = slide(1, 0, threshold, 0.01, 0.4);
            double place = turn / 2 - g * (1 - MU) * (0.4 - turn) * (0.4 - turn) / 2;
            assertEquals(place * SLOPE, entry(system, 0), 1e-12);
            assertEquals(-g * (1 - MU) * (0.4 - turn) * SLOPE, entry(system, 3), 1e-12);
            assertEquals(threshold > 0 ? 2 : 1, events);
        }
    }

    /**
     * An oblique slide never stops, however large the steps. Within a step of 0.01 s it turns by more than a right
     * angle at a hundredth of its speed, and keeps its velocity across the slope: no jump is booked, and it ends where
     * steps a fiftieth as long take it (measured: 3.5e-5 m apart, and 2 % of the speed across).
     */
    @Test
    void anObliqueSlideTurnsWithoutStopping() {
        ParticleSystem small = slide(1, 0.05, 0, 0.0002, 0.4);
        double alongSmall = entry(small, 5);
        double downSmall = entry(small, 0);
        assertTrue(alongSmall > 0.005, "friction leaves " + alongSmall);
        ParticleSystem large = slide(1, 0.05, 0, 0.01, 0.4);
        assertEquals(alongSmall, entry(large, 5), 0.1 * alongSmall);
        assertEquals(downSmall, entry(large, 0), 2e-4);
        assertEquals(0, ledger.getWork().getOrDefault("impacts", 0.0), 1e-15);
    }
}
