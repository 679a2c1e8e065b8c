package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;
import static particles.Systems.entry;
import static particles.Systems.oneParticle;

import deSolvers.RK4Solver;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.effects.Gravity;
import particles.energy.EnergyLedger;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/**
 * A clamped bounce uses the speed at the surface, not at the depth where the step ended: after n bounces the energy is
 * r<sup>2n</sup> m g h for any deltaT; only the times are late.
 */
class ClampedBouncesTest {
    private static final double G = 9.81;

    /** A particle of 1 kg that bounces under gravity; records its energy after every change. */
    private static final class Bounces implements Observer {
        private final ParticleSystem system;
        private final EnergyLedger ledger = new EnergyLedger();
        private final List<Double> energies = new ArrayList<>();
        private final List<Double> times = new ArrayList<>();

        Bounces(Vector3 from, Vector3 velocity, double deltaT, double duration, ContactSurface... surfaces) {
            system = oneParticle(from, velocity);
            RestingContacts contacts = new RestingContacts(system, List.of(surfaces));
            system.addEffect(new Gravity(system.getParticles(), GRAVITY));
            system.addReaction(contacts);
            Simulation simulation = new Simulation(system, RK4Solver::new, deltaT, duration);
            simulation.addRule(new ClampedImpacts(contacts));
            simulation.addObserver(ledger);
            simulation.addObserver(this);
            simulation.run();
        }

        @Override
        public void changed(ParticleSystem bounced, Rule by) {
            energies.add(bounced.getEnergy(bounced.getOwnState(), bounced.getTime()));
            times.add(bounced.getTime());
        }

        /** The largest relative change of the initial energy. */
        double worst() {
            double worst = 0;
            for (double energy : energies) {
                worst = Math.max(worst, Math.abs(energy / ledger.getStartEnergy() - 1));
            }
            return worst;
        }
    }

    private static ContactSurface ground(double restitution, double restSpeed) {
        return new ContactSurface("ground", Plane.ground(0), restitution, Friction.NONE, restSpeed);
    }

    private static ContactSurface slope(double nx, double ny) {
        return new ContactSurface("slope", new Plane(Vector3.ZERO, new Vector3(nx, ny, 0)), 1, Friction.NONE, 0);
    }

    /**
     * Dropped from 1 m, it rises to r<sup>2n</sup> m after n bounces. Each bounce is late by less than a step, so the
     * n-th by less than n steps. Bounces end when a step cannot resolve them, r<sup>n</sup> v &lt;= g deltaT.
     */
    @ParameterizedTest
    @CsvSource({"0.9, 0.01", "0.9, 0.02", "0.9, 0.0333", "0.8, 0.01", "0.95, 0.005"})
    void bounceHeightsFollowTheFormulaUntilRest(double r, double deltaT) {
        double fall = Math.sqrt(2 / G);
        Bounces ball = new Bounces(new Vector3(0, 1, 0), Vector3.ZERO, deltaT, 30, ground(r, 0));
        int last = ball.energies.size() - 1;
        for (int n = 0; n < last; n++) {
            assertEquals(1, ball.energies.get(n) / (G * Math.pow(r, 2 * n + 2)), 1e-12, "bounce " + n);
            double time = fall + 2 * fall * r * (1 - Math.pow(r, n)) / (1 - r);
            assertEquals(time + (n + 1) * deltaT / 2, ball.times.get(n), (n + 1) * deltaT / 2, "bounce " + n);
        }
        assertEquals(Math.ceil(Math.log(deltaT / fall) / Math.log(r)), last + 1, 1, "bounces that deltaT can resolve");
        assertEquals(0, entry(ball.system, 1));
        assertEquals(0, entry(ball.system, 4));
    }

    /** Its energy is unchanged after 1000 bounces. */
    @ParameterizedTest
    @ValueSource(doubles = {0.005, 0.01, 0.02, 0.0333})
    void anElasticBallKeepsItsEnergy(double deltaT) {
        Bounces ball = new Bounces(new Vector3(0, 1, 0), new Vector3(0.1, 0, 0), deltaT, 960, ground(1, 1e-3));
        assertTrue(ball.energies.size() > 1000, "bounces: " + ball.energies.size());
        assertEquals(0, ball.worst(), 4e-14, "measured: 5e-15 at most");
    }

    /** An impact loses (1 - r&sup2;) m g h, and the ledger books that, even at a step as long as a frame. */
    @Test
    void theLedgerBooksTheLossOfAnImpact() {
        Bounces ball = new Bounces(new Vector3(0, 1, 0), Vector3.ZERO, 1.0 / 30, 0.6, ground(0.5, 0));
        assertEquals(-0.75 * G, ball.ledger.getWork().get("impacts"), 1e-13, "measured: 2e-15");
        assertEquals(0, ball.ledger.getNumericalError(), 1e-13, "measured: 1e-15");
    }

    /** Energy stays the same in a groove of two slopes, and on a ball hit off-centre so that a step ends inside it. */
    @ParameterizedTest
    @ValueSource(doubles = {0.002, 0.01, 0.02})
    void slopesAndBallsAddNoEnergy(double deltaT) {
        Bounces groove = new Bounces(new Vector3(-0.3, 1, 0), Vector3.ZERO, deltaT, 60, slope(1, 1), slope(-0.8, 1));
        assertTrue(groove.energies.size() > 100, "bounces: " + groove.energies.size());
        assertEquals(0, groove.worst(), 5e-13, "measured: 6e-14 at most");
        ContactSurface ball = new ContactSurface("ball", new Sphere(Vector3.ZERO, 0.5, false), 1, Friction.NONE, 0);
        Bounces off = new Bounces(new Vector3(0.2, 1.5, 0.1), Vector3.ZERO, deltaT, 1, ball);
        assertEquals(1, off.energies.size(), "bounces");
        assertEquals(0, off.worst(), 5e-9, "the entry point is 1e-9 m below the surface; measured: 1.04e-9");
    }

    /** A particle that begins below the surface and rises loses speed on the way: v&sup2; = v0&sup2; - 2 g depth. */
    @Test
    void aParticleFromBelowLeavesWithItsSpeedAtTheSurface() {
        Bounces born = new Bounces(new Vector3(0, -0.02, 0), new Vector3(0, 5, 0), 0.001, 0.001, ground(0.5, 0));
        assertEquals(0, entry(born.system, 1), 1e-16);
        assertEquals(Math.sqrt(25 - 2 * G * 0.02), entry(born.system, 4), 1e-13);
    }
}
