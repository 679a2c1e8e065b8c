package particles.rules;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;

import deSolvers.RK4Solver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.effects.Cohesion;
import particles.effects.Gravity;
import particles.effects.LinearDrag;
import particles.effects.TurbulentWind;
import particles.effects.springs.SpringForce;
import particles.energy.EnergyLedger;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.SeededRandom;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/** Births, deaths, tears, mergers and splits: their times, conserved quantities, and entries in the energy ledger. */
class BirthAndDeathTest {

    private static Emitter emitter(double rate, double lifetime, long seed) {
        Emitter.Jet jet = new Emitter.Jet(new Vector3(0, 1, 0), 0.1, new Vector3(1, 2, 0), 0.4, 3);
        return new Emitter(new Emitter.Nozzle("drop", jet, rate, 0.5, lifetime, seed));
    }

    private static Simulation simulation(ParticleSystem system, double deltaT, double duration, Rule... rules) {
        Simulation simulation = new Simulation(system, RK4Solver::new, deltaT, duration);
        for (Rule rule : rules) {
            simulation.addRule(rule);
        }
        return simulation;
    }

    private static double[] state(ParticleSystem system) {
        return Arrays.copyOf(system.getOwnState(), system.getStateSize());
    }

    /** Particle n is born at n/rate: 70 in 1 s for any deltaT, each in the nozzle and moving inside the cone. */
    @Test
    void particlesAreBornAtTheirTimesInTheCone() {
        for (double deltaT : new double[] {0.25, 0.01, 0.001}) {
            ParticleSystem system = new ParticleSystem();
            simulation(system, deltaT, 1.005, emitter(70, 9, 1)).run();
            Particles particles = system.getParticles();
            assertEquals(70, particles.count());
            double[] state = state(system);
            for (int i = 0; i < 70; i++) {
                assertEquals("drop[" + i + "]", particles.id(i));
                assertEquals((i + 1) / 70.0, particles.birthTime(i), 1e-15);
                assertEquals((i + 1) / 70.0 + 9, particles.deathTime(i), 1e-14);
                Vector3 v = new Vector3(state[6 * i + 3], state[6 * i + 4], state[6 * i + 5]);
                double age = 1.005 - particles.birthTime(i);
                Vector3 from = new Vector3(state[6 * i], state[6 * i + 1], state[6 * i + 2]).minus(v.times(age));
                assertEquals(3, v.length(), 1e-14);
                assertTrue(v.normalized().dot(new Vector3(1, 2, 0).normalized()) >= Math.cos(0.4) - 1e-14);
                assertTrue(from.minus(new Vector3(0, 1, 0)).length() <= 0.1 + 1e-12,
                        "without forces it came straight from there");
            }
        }
    }

    @Test
    void theSameSeedGivesTheSameRun() {
        List<double[]> runs = new ArrayList<>();
        for (long seed : new long[] {1, 1, 2}) {
            ParticleSystem system = new ParticleSystem();
            simulation(system, 0.01, 1, emitter(50, 0.3, seed), new Lifetimes()).run();
            runs.add(state(system));
        }
        assertArrayEquals(runs.get(0), runs.get(1));
        assertFalse(Arrays.equals(runs.get(0), runs.get(2)));
    }

    /**
     * In equilibrium rate times lifetime particles are alive, none older than its lifetime, and no id is used twice.
     */
    @Test
    void particlesDieAtTheEndOfTheirLifetime() {
        ParticleSystem system = new ParticleSystem();
        Emitter emitter = emitter(200, 0.5, 1);
        Set<String> seen = new HashSet<>();
        Set<String> before = new HashSet<>();
        Simulation simulation = simulation(system, 0.01, 3, emitter, new Lifetimes(), new KillPlane(Plane.ground(0.5)));
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        simulation.addObserver(new Observer() {
            @Override
            public void changed(ParticleSystem s, Rule rule) {
                Set<String> now = new HashSet<>();
                for (int i = 0; i < s.getParticles().count(); i++) {
                    String id = s.getParticles().id(i);
                    now.add(id);
                    assertTrue(before.contains(id) || seen.add(id), id + " was used before");
                    assertTrue(rule != emitter || s.getParticles().deathTime(i) > s.getTime() - 0.01 - 1e-9);
                }
                before.clear();
                before.addAll(now);
            }
        });
        simulation.run();
        assertEquals(600, emitter.getBorn());
        assertEquals(600, seen.size());
        assertTrue(system.getParticles().count() <= 101, "rate times lifetime, and one at the edge");
        assertTrue(system.getParticles().count() > 40, "" + system.getParticles().count());
    }

    /** The ledger books the energy of each birth and death once: after thousands only round-off remains unexplained. */
    @Test
    void birthsDeathsAndImpactsAreBookedOnce() {
        ParticleSystem system = new ParticleSystem();
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        RestingContacts contacts = new RestingContacts(system,
                List.of(new ContactSurface("ground", Plane.ground(0), 0.4, Friction.NONE, 1e-3)));
        system.addReaction(contacts);
        Simulation simulation = new Simulation(system, RK4Solver::new, 0.01, 4);
        simulation.addRule(new ExactImpacts(contacts));
        for (Rule rule : new Rule[] {emitter(100, 1.5, 3), new Lifetimes(),
                new KillPlane(new Plane(new Vector3(3, 0, 0),
                new Vector3(-1, 0, 0)))}) {
            simulation.addRule(rule);
        }
        EnergyLedger ledger = new EnergyLedger();
        simulation.addObserver(ledger);
        simulation.run();
        assertTrue(ledger.getWork().get("emitter") > 2000, ledger.getWork().toString());
        assertTrue(ledger.getWork().get("age") < -100, ledger.getWork().toString());
        assertTrue(ledger.getWork().get("impacts") < -100, ledger.getWork().toString());
        assertTrue(ledger.getWork().get("kill") < -10, ledger.getWork().toString());
        assertEquals(0, ledger.getNumericalError(), 1e-9 * ledger.getWork().get("emitter"));
    }

    /** A slowly pulled spring tears at 1.5 times its length; the ledger books its k (l/2)&sup2;/2 = 12.5 J once. */
    @Test
    void aTornSpringsEnergyIsBookedOnce() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("hand", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("wall", 1, new Vector3(1, 0, 0), Vector3.ZERO, true);
        system.addParticle("bob", 1, new Vector3(1, 1, 0), Vector3.ZERO, false);
        SpringForce springs = new SpringForce(system.getParticles());
        springs.addSpring(0, 1, 100, 1, 0);
        springs.addSpring(1, 2, 100, 1, 0);
        springs.addSpring(0, 2, 0, 0, 0);
        system.addEffect(springs);
        system.moveAnchor(0, new GlideMotion(Vector3.ZERO, new Vector3(-1, 0, 0), 2));
        EnergyLedger ledger = new EnergyLedger();
        Simulation simulation = simulation(system, 0.001, 2, new SpringTear(springs, 0.5));
        simulation.addObserver(ledger);
        simulation.run();
        assertEquals(2, springs.springCount(), "the spring of rest length 0 never tears");
        assertEquals(-12.5, ledger.getWork().get("tear"), 0.05);
        assertEquals(-ledger.getWork().get("tear"), ledger.getWork().get("moving anchors"), 1e-6,
                "the hand did the work");
        assertEquals(0, ledger.getNumericalError(), 1e-6);
        assertEquals(0, ledger.getEnergy(), 1e-12);
    }

    /**
     * Merging conserves mass and momentum and loses the energy of the relative motion, m v&sup2;/4 with m the mass of
     * each.
     */
    @Test
    void closeParticlesMerge() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, new Vector3(-1, 0, 0), new Vector3(1, 0, 0), false);
        system.addParticle("b", 3, new Vector3(1, 0, 0), new Vector3(-1, 2, 0), false);
        EnergyLedger ledger = new EnergyLedger();
        Simulation simulation = simulation(system, 0.01, 2,
                new ParticleResampler("s", new SpringForce(system.getParticles()), 2.5, 6, 9, 1));
        simulation.addObserver(ledger);
        simulation.run();
        assertEquals(1, system.getParticles().count());
        assertEquals("s[0]", system.getParticles().id(0));
        assertEquals(4, system.getParticles().mass(0));
        assertArrayEquals(new double[] {-0.5, 1.5, 0}, Arrays.copyOfRange(state(system), 3, 6), 1e-15);
        assertEquals(-0.5 * 0.75 * 8, ledger.getWork().get("samples"), 1e-13,
                "reduced mass times the square of the difference");
        assertEquals(0, ledger.getNumericalError(), 1e-13);
    }

    /**
     * Eight heavy particles in turbulence become many: the mass stays to the last bit (it is halved and added),
     * momentum with it at every change, ids are new, and none is lighter than allowed or has its partner
     * closer than allowed for long.
     */
    @Test
    void samplesStayEvenAndKeepMassAndMomentum() {
        ParticleSystem system = new ParticleSystem();
        SeededRandom random = new SeededRandom(4);
        for (int i = 0; i < 8; i++) {
            system.addParticle("p" + i, 1, random.nextDirection(new Vector3(0, 1, 0), Math.PI).times(0.3), Vector3.ZERO,
                    false);
        }
        system.addEffect(new LinearDrag(system.getParticles(), 0.5, new TurbulentWind(Vector3.ZERO, 1, 0.8, 9)));
        ParticleResampler even = new ParticleResampler("s", new SpringForce(system.getParticles()), 0.06, 0.2, 1.0 / 16,
                3);
        Simulation simulation = simulation(system, 0.01, 3, even);
        double[] before = new double[3];
        simulation.addObserver(new Observer() {
            @Override
            public void moved(particles.Motion motion) {
                System.arraycopy(momentum(system), 0, before, 0, 3);
            }

            @Override
            public void changed(ParticleSystem s, Rule rule) {
                assertArrayEquals(before, momentum(s), 1e-14);
                assertEquals(8.0, mass(s), "halves and sums of such numbers are exact");
            }
        });
        simulation.run();
        assertTrue(system.getParticles().count() > 20, "many became of eight: " + system.getParticles().count());
        int tooClose = 0;
        double[] state = state(system);
        for (int i = 0; i < system.getParticles().count(); i++) {
            assertTrue(system.getParticles().mass(i) >= 1.0 / 16);
            for (int j = 0; j < i; j++) {
                tooClose += new Vector3(state[6 * i] - state[6 * j], state[6 * i + 1] - state[6 * j + 1],
                        state[6 * i + 2] - state[6 * j + 2]).length() < 0.06 ? 1 : 0;
            }
        }
        assertTrue(tooClose <= 1, "pairs left that are too close: " + tooClose);
    }

    private static double mass(ParticleSystem system) {
        double mass = 0;
        for (int i = 0; i < system.getParticles().count(); i++) {
            mass += system.getParticles().mass(i);
        }
        return mass;
    }

    private static double[] momentum(ParticleSystem system) {
        double[] sum = new double[3];
        for (int i = 0; i < system.getParticles().count(); i++) {
            for (int c = 0; c < 3; c++) {
                sum[c] += system.getParticles().mass(i) * system.getOwnState()[6 * i + 3 + c];
            }
        }
        return sum;
    }

    /** Fixed particles and those with springs stay as they are, however close or isolated. */
    @Test
    void tiedAndFixedParticlesNeitherMergeNorSplit() {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < 4; i++) {
            system.addParticle("p" + i, 8, new Vector3(0.01 * i, 0, 0), Vector3.ZERO, i == 3);
        }
        SpringForce springs = new SpringForce(system.getParticles());
        springs.addSpring(0, 1, 0, 0, 0);
        springs.addSpring(1, 2, 0, 0, 0);
        assertFalse(new ParticleResampler("s", springs, 0.1, 0.5, 1, 1).afterStep(system, 0.01));
        assertEquals(4, system.getParticles().count());
    }

    /** Springs keep their particles when particles with smaller indices die. */
    @Test
    void springsKeepTheirParticlesWhenOthersDie() {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < 6; i++) {
            system.addParticle("p" + i, 1, new Vector3(i, 0, 0), Vector3.ZERO, false);
        }
        SpringForce springs = new SpringForce(system.getParticles());
        springs.addSpring(0, 1, 10, 1, 0);
        springs.addSpring(4, 5, 20, 0.5, 0);
        system.addEffect(springs);
        system.addEffect(new Cohesion(system.getParticles(), 2, 1.2, 1, 0));
        system.setLife(1, 0, 0.5);
        system.setLife(2, 0, 0.5);
        simulation(system, 0.1, 0.6, new Lifetimes()).run();
        assertEquals(4, system.getParticles().count());
        assertEquals(1, springs.springCount());
        assertEquals(2, springs.from(0));
        assertEquals(20, springs.stiffness(0));
        assertEquals("p4", system.getParticles().id(springs.from(0)));
    }
}
