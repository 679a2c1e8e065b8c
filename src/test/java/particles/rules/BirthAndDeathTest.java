package particles.rules;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.springs;

import deSolvers.RK4Solver;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Systems;
import particles.effects.Cohesion;
import particles.effects.springs.SpringForce;
import particles.law.Particles;
import particles.law.Vector3;
import particles.scene.ShortRun;

/** Births, deaths, tears, mergers and splits: their times, conserved quantities, and entries in the energy ledger. */
class BirthAndDeathTest {

    /** A jet of drops, in a cone of 0.4 rad; a fixed particle is there from the start, far away. */
    private static ShortRun jet(String steps, int rate, double lifetime, int seed, String effects, String... rules) {
        return new ShortRun("rk4 " + steps, """
                particles: [{id: source, position: [-9, 9, 0], fixed: true}]
                effects: [%s]
                rules:
                  - emitter: {id: drop, position: [0, 1, 0], radius: 0.1, direction: [1, 2, 0], spread: %s, speed: 3,
                              rate: %s, mass: 0.5, lifetime: %s, seed: %s}
                """.formatted(effects, Math.toDegrees(0.4), rate, lifetime, seed) + String.join("\n", rules));
    }

    private static Vector3 vector(ShortRun run, int k) {
        return new Vector3(run.at(k), run.at(k + 1), run.at(k + 2));
    }

    /** Particle n is born at n/rate: 70 in 1 s for any deltaT, each in the nozzle and moving inside the cone. */
    @ParameterizedTest
    @ValueSource(strings = {"0.25", "0.01", "0.001"})
    void particlesAreBornAtTheirTimesInTheCone(String deltaT) {
        ShortRun run = jet("clamp " + deltaT + " 1.005", 70, 9, 1, "").run();
        Particles particles = run.getSystem().getParticles();
        assertEquals(71, particles.count());
        for (int i = 1; i <= 70; i++) {
            assertEquals("drop[" + (i - 1) + "]", particles.id(i));
            assertEquals(i / 70.0, particles.birthTime(i), 1e-15);
            assertEquals(i / 70.0 + 9, particles.deathTime(i), 1e-14);
            Vector3 v = vector(run, 6 * i + 3);
            Vector3 from = vector(run, 6 * i).minus(v.times(1.005 - particles.birthTime(i)));
            assertEquals(3, v.length(), 1e-14);
            assertTrue(v.normalized().dot(new Vector3(1, 2, 0).normalized()) >= Math.cos(0.4) - 1e-14);
            assertTrue(from.minus(new Vector3(0, 1, 0)).length() <= 0.1 + 1e-12,
                    "without forces it came straight from there");
        }
    }

    @Test
    void theSameSeedGivesTheSameRun() {
        double[][] runs = new double[3][];
        for (int k = 0; k < 3; k++) {
            ParticleSystem system = jet("clamp 0.01 1", 50, 0.3, k / 2, "").run().getSystem();
            runs[k] = Arrays.copyOf(system.getOwnState(), system.getStateSize());
        }
        assertArrayEquals(runs[0], runs[1]);
        assertFalse(Arrays.equals(runs[0], runs[2]));
    }

    /**
     * In equilibrium rate times lifetime particles are alive, none older than its lifetime, and no id is used twice.
     */
    @Test
    void particlesDieAtTheEndOfTheirLifetime() {
        Set<String> seen = new HashSet<>();
        Set<String> before = new HashSet<>();
        ShortRun run = jet("clamp 0.01 3", 200, 0.5, 1, "gravity", "  - kill: {point: [0, 0.5, 0]}");
        run.getSimulation().addObserver(new Observer() {
            @Override
            public void changed(ParticleSystem s, Rule rule) {
                Set<String> now = new HashSet<>();
                for (int i = 0; i < s.getParticles().count(); i++) {
                    String id = s.getParticles().id(i);
                    now.add(id);
                    assertTrue(before.contains(id) || seen.add(id), id + " was used before");
                    assertTrue(!(rule instanceof Emitter) || s.getParticles().deathTime(i) > s.getTime() - 0.01 - 1e-9);
                }
                before.clear();
                before.addAll(now);
            }
        });
        run.run();
        assertEquals(601, seen.size());
        int alive = run.getSystem().getParticles().count();
        assertTrue(alive <= 102 && alive > 41, "rate times lifetime, one at the edge and one fixed: " + alive);
    }

    /** The ledger books the energy of each birth and death once: after thousands only round-off remains unexplained. */
    @Test
    void birthsDeathsAndImpactsAreBookedOnce() {
        ShortRun run = jet("exact 0.01 4", 100, 1.5, 3, "gravity", "  - ground: {restitution: 0.4, restSpeed: 1e-3}",
                "  - kill: {point: [3, 0, 0], normal: [-1, 0, 0]}").run();
        assertTrue(run.work("emitter") > 2000 && run.work("age") < -100 && run.work("impacts") < -100
                && run.work("kill") < -10, "" + run.getLedger().getWork());
        assertEquals(0, run.getNumericalError(), 1e-9 * run.work("emitter"));
    }

    /** A slowly pulled spring tears at 1.5 times its length; the ledger books its k (l/2)&sup2;/2 = 12.5 J once. */
    @Test
    void aTornSpringsEnergyIsBookedOnce() {
        ShortRun run = ShortRun.of("rk4 clamp 0.001 2", """
                particles:
                  - {id: hand, position: [0, 0, 0], fixed: true}
                  - {id: wall, position: [1, 0, 0], fixed: true}
                  - {id: bob, position: [1, 1, 0]}
                springs:
                  - {from: hand, to: wall, stiffness: 100, restLength: 1}
                  - {from: wall, to: bob, stiffness: 100, restLength: 1}
                  - {from: hand, to: bob, stiffness: 1e-30, restLength: 0}
                effects: []
                rules: [tear: {strain: 0.5}, glide: {particle: hand, to: [-1, 0, 0], duration: 2}]
                """);
        assertEquals(2, run.getScene().springs().springCount(), "the spring of rest length 0 never tears");
        assertEquals(-12.5, run.work("tear"), 0.05);
        assertEquals(-run.work("tear"), run.work("moving anchors"), 1e-6, "the hand did the work");
        assertEquals(0, run.getNumericalError(), 1e-6);
        assertEquals(0, run.getLedger().getEnergy(), 1e-12);
    }

    /**
     * Merging conserves mass and momentum and loses the energy of the relative motion, m v&sup2;/4 with m the mass of
     * each.
     */
    @Test
    void closeParticlesMerge() {
        ShortRun run = ShortRun.of("rk4 clamp 0.01 2", """
                particles:
                  - {id: a, position: [-1, 0, 0], velocity: [1, 0, 0]}
                  - {id: b, position: [1, 0, 0], velocity: [-1, 2, 0], mass: 3}
                effects: []
                rules: [samples: {id: s, farthest: 6, closest: 0.4166666666666667, lightest: 9}]
                """);
        Particles particles = run.getSystem().getParticles();
        assertEquals(1, particles.count());
        assertEquals("s[0]", particles.id(0));
        assertEquals(4, particles.mass(0));
        assertEquals(0, vector(run, 3).minus(new Vector3(-0.5, 1.5, 0)).length(), 1e-15);
        assertEquals(-0.5 * 0.75 * 8, run.work("samples"), 1e-13, "reduced mass times the square of the difference");
        assertEquals(0, run.getNumericalError(), 1e-13);
    }

    /**
     * Eight heavy particles in turbulence become many: the mass stays to the last bit (it is halved and added),
     * momentum with it at every change, ids are new, and none is lighter than allowed or has its partner
     * closer than allowed for long.
     */
    @Test
    void samplesStayEvenAndKeepMassAndMomentum() {
        ShortRun run = new ShortRun("rk4 clamp 0.01 3", """
                shapes: [jelly: {centre: [0, 0, 0], size: [0.35, 0.35, 0.35], columns: 2, rows: 2, layers: 2, mass: 1,
                                 surface: false}]
                effects: [drag: {coefficient: 0.5}, turbulence: {strength: 1, eddySize: 0.8, seed: 9}]
                rules: [samples: {farthest: 0.2, closest: 0.3, lightest: 0.0625, seed: 3}]
                """);
        ParticleSystem system = run.getSystem();
        double[] before = new double[3];
        run.getSimulation().addObserver(new Observer() {
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
        run.run();
        int count = system.getParticles().count();
        assertTrue(count > 20, "many became of eight: " + count);
        int tooClose = 0;
        for (int i = 0; i < count; i++) {
            assertTrue(system.getParticles().mass(i) >= 1.0 / 16);
            for (int j = 0; j < i; j++) {
                tooClose += run.distance(i, j) < 0.06 ? 1 : 0;
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
        ParticleSystem system = Systems.row(6);
        SpringForce springs = springs(system);
        springs.addSpring(0, 1, 10, 1, 0);
        springs.addSpring(4, 5, 20, 0.5, 0);
        system.addEffect(new Cohesion(system.getParticles(), 2, 1.2, 1, 0));
        system.setLife(1, 0, 0.5);
        system.setLife(2, 0, 0.5);
        Systems.run(system, new RK4Solver(), 0.1, 0.6, Deaths.ofAge());
        assertEquals(4, system.getParticles().count());
        assertEquals(1, springs.springCount());
        assertEquals(2, springs.from(0));
        assertEquals(20, springs.stiffness(0));
        assertEquals("p4", system.getParticles().id(springs.from(0)));
    }
}
