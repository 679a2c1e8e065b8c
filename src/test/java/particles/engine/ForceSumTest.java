package particles.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.effects.AirDrag;
import particles.effects.Gravity;
import particles.effects.GustyWind;
import particles.effects.Push;
import particles.effects.Wind;
import particles.law.ParticleForce;
import particles.law.Particles;
import particles.law.Vector3;

/** A system's derivative is (v, F/m), with F the sum of what its effects add. */
class ForceSumTest {
    private static final int N = 1100;                  // three of the groups in which particles are evaluated
    private static final Vector3 G = new Vector3(0.3, -9.81, 1.7);

    private final ParticleSystem system = new ParticleSystem();
    private final Particles particles = system.getParticles();
    private final double[] state = new double[6 * N];

    ForceSumTest() {
        Random random = new Random(11);
        for (int i = 0; i < N; i++) {
            boolean fixed = i % 7 == 0;
            Vector3 velocity = new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            system.addParticle("p" + i, 0.1 + random.nextDouble(), velocity, fixed ? Vector3.ZERO : velocity, fixed);
        }
        system.getState(state);
    }

    /** (v, F/m), with F from each effect alone. */
    private double[] byLoops() {
        double[] dSdt = new double[6 * N];
        system.addUpEffects(state, 0, dSdt);
        for (int e = 0; e < dSdt.length; e++) {
            dSdt[e] = e % 6 < 3 ? state[e + 3] : dSdt[e] * particles.getInverseMasses()[e / 6];
        }
        return dSdt;
    }

    private double[] derivative() {
        double[] dSdt = new double[6 * N];
        system.getStateDerivative(dSdt);
        return dSdt;
    }

    /** Evaluation in groups of particles gives the same bits as each effect's own loop. */
    @Test
    void theDerivativeIsTheSumOfTheEffects() {
        assertArrayEquals(byLoops(), derivative(), "free flight");
        system.addEffect(AirDrag.linear(particles, 0.25, Wind.STILL));
        assertArrayEquals(byLoops(), derivative(), "drag alone, added after an evaluation");
        system.addEffect(new Gravity(particles, G));
        assertArrayEquals(byLoops(), derivative(), "drag and gravity");
        double[] dSdt = derivative();
        assertEquals(G.y() - 0.25 * state[6 + 4] / particles.mass(1), dSdt[6 + 4], 1e-14,
                "by hand; the quotient is rounded once more");
        assertTrue(dSdt[4] == 0, "a fixed particle");
        system.addEffect(AirDrag.quadratic(particles, 0.5, Wind.STILL));
        system.addEffect(AirDrag.linear(particles, 0.5, new GustyWind(new Vector3(1, 0, 0), new Vector3(0, 1, 0), 3)));
        system.addEffect(new Gravity(particles, G));
        assertArrayEquals(byLoops(), derivative(), "several of each");
    }

    /** Constant forces are evaluated once, and again for other particles: the third time for as many as before. */
    @Test
    void constantForcesFollowTheParticles() {
        system.addEffect(new Gravity(particles, G));
        system.addEffect(new Push(particles, IntStream.of(1, 2, N - 1).mapToObj(particles::id)
                .collect(Collectors.toSet()), G));
        system.addEffect(AirDrag.linear(particles, 0.25, Wind.STILL));
        assertArrayEquals(byLoops(), derivative());
        state[3] = 5;
        system.setState(state);
        assertArrayEquals(byLoops(), derivative(), "another velocity");
        boolean[] gone = new boolean[N];
        gone[1] = true;
        system.removeParticles(gone);
        system.addParticle("new", 7, Vector3.ZERO, Vector3.ZERO, false);
        system.getState(state);
        assertArrayEquals(byLoops(), derivative(), "one left, another came");
    }

    /** Effects without ranges come after those with ranges, which changes the round-off of three terms. */
    @Test
    void effectsWithoutRangesAreAddedLast() {
        system.addEffect(new ParticleForce(particles) {
            @Override
            protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                return position.times(-mass);
            }
        });
        system.addEffect(new Gravity(particles, G));
        system.addEffect(AirDrag.quadratic(particles, 0.5, Wind.STILL));
        double[] loops = byLoops();
        double[] dSdt = derivative();
        for (int e = 0; e < loops.length; e++) {
            assertEquals(loops[e], dSdt[e], 1e-14 * Math.max(1, Math.abs(loops[e])), "entry " + e);
        }
    }
}
