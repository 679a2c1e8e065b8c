package particles.engine;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static particles.Systems.addGravity;
import static particles.Systems.springs;

import deSolvers.RK4Solver;
import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Cloth;
import particles.ParticleSystem;
import particles.effects.AirDrag;
import particles.effects.Wind;
import particles.effects.springs.SpringForce;
import particles.law.ParticleForce;
import particles.law.PerParticleEffect;
import particles.law.Vector3;

/**
 * Any number of threads gives the same bits. The caller has to be a thread of no pool, as in a program: `gradle
 * test` runs tests in a pool, where parts of a step would wait for other tests.
 */
@Tag("slow")
class ThreadsTest {
    private static final int STEPS = 20;

    /** Cloth of 3600 particles and some 21,000 springs, in four blocks. */
    private static ParticleSystem cloth() {
        ParticleSystem cloth = Cloth.hanging(60, 20, 0.02);
        cloth.addEffect(AirDrag.linear(cloth.getParticles(), 0.01, Wind.STILL));
        return cloth;
    }

    /** Springs, in random order, between particles whose indices differ by at most {@code reach}. */
    private static ParticleSystem network(int reach) {
        return network(reach, 20_000);
    }

    private static ParticleSystem network(int reach, int count) {
        ParticleSystem network = new ParticleSystem();
        Random random = new Random(11);
        int n = 3000;
        for (int i = 0; i < n; i++) {
            network.addParticle("p" + i, 1 + random.nextDouble(), new Vector3(random.nextDouble(), random.nextDouble(),
                    i * 0.01),
                    Vector3.ZERO, i % 500 == 0);
        }
        addGravity(network);
        SpringForce springs = springs(network);
        for (int s = 0; s < count; s++) {
            int i = random.nextInt(n);
            int j = Math.floorMod(i + 1 + random.nextInt(reach), n);
            springs.addSpring(i, j, 10, 0.5, 0.1);
        }
        return network;
    }

    private static double[] stateAfter(ParticleSystem system, int threads, int steps) {
        ParallelForces.use(system.getForceSum(), threads);
        Steps.make(steps, new RK4Solver(), system, 1.0 / 1024);
        return system.getStateArray().clone();
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 7})
    void anyNumberOfThreadsGivesTheBitsOfOne(int threads) {
        assertArrayEquals(stateAfter(cloth(), 1, STEPS), stateAfter(cloth(), threads, STEPS));
        assertFalse(Arrays.equals(stateAfter(cloth(), 1, STEPS), stateAfter(cloth(), threads, STEPS + 1)));
        assertArrayEquals(stateAfter(network(100), 1, STEPS), stateAfter(network(100), threads, STEPS));
        assertArrayEquals(stateAfter(network(2999), 1, STEPS), stateAfter(network(2999), threads, STEPS));
    }

    /** Eight blocks shared out to different numbers of threads. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6, 9})
    void theDistributionOfBlocksChangesNoBit(int threads) {
        assertEquals(8, ((SpringForce) network(100, 40_000).getEffects().get(1)).countBlocks());
        assertArrayEquals(stateAfter(network(100, 40_000), 1, 5), stateAfter(network(100, 40_000), threads, 5));
    }

    /** Compares ends with up to so many threads to that with one. */
    private static void assertSameBits(int most, IntFunction<double[]> end) {
        for (int threads = 2; threads <= most; threads++) {
            assertArrayEquals(end.apply(1), end.apply(threads), threads + " threads");
        }
    }

    /** One particle has springs in the last block and in the rest. */
    @Test
    void aParticleWithSpringsInABlockAndAfterItHasTheSameBits() {
        assertSameBits(2, threads -> {
            ParticleSystem pairs = new ParticleSystem();
            SpringForce springs = springs(pairs);
            Random random = new Random(12);
            for (int i = 0; i < 1000; i++) {
                pairs.addParticle("p" + i, 1, new Vector3(random.nextDouble(), random.nextDouble(), i), Vector3.ZERO,
                        false);
            }
            for (int s = 0; s < 20_000; s++) {
                springs.addSpring(s / 40 * 2, s / 40 * 2 + 1, random.nextDouble(), random.nextDouble(), 0.1);
            }
            for (int s = 0; s < 5; s++) {
                springs.addSpring(998, s, random.nextDouble(), random.nextDouble(), 0.1);
                springs.addSpring(998, 500 + s, random.nextDouble(), random.nextDouble(), 0.1);
            }
            double[] end = stateAfter(pairs, threads, STEPS);
            assertEquals(4, springs.countBlocks());
            assertEquals(20_000, springs.getPartStart(4), "the last block ends here");
            return end;
        });
    }

    /** A {@link ParticleForce}, and an effect without ranges, which one thread evaluates. */
    @Test
    void lawsWithoutRangesHaveTheSameBits() {
        assertSameBits(3, threads -> {
            ParticleSystem cloth = cloth();
            Vector3 wind = new Vector3(1, 0.5, 0.25);
            cloth.addEffect(new ParticleForce(cloth.getParticles()) {
                @Override
                protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                    return wind.minus(velocity).times(mass);
                }
            });
            addGravity(cloth);
            return stateAfter(cloth, threads, STEPS);
        });
    }

    @Test
    void removingSpringsKeepsTheBits() {
        assertSameBits(3, threads -> {
            ParticleSystem network = network(100);
            stateAfter(network, threads, STEPS);
            SpringForce springs = (SpringForce) network.getEffects().get(1);
            boolean[] torn = new boolean[springs.springCount()];
            for (int s = 0; s < torn.length; s += 7) {
                torn[s] = true;
            }
            springs.removeSprings(torn);
            boolean[] gone = new boolean[network.getParticles().count()];
            for (int i = 1; i < gone.length; i += 11) {
                gone[i] = true;
            }
            network.removeParticles(gone);
            return stateAfter(network, threads, STEPS);
        });
    }

    @Test
    void fewerThanOneThreadIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> ParallelForces.use(cloth().getForceSum(), 0));
    }

    /**
     * Nothing but a task of 24 bytes for each part, whatever the number of particles. The caller evaluates all parts
     * here, since every other thread of the pool is held. (Where it waits for one, the JDK allocates 24 bytes more.)
     */
    @Test
    void parallelStepsAllocateATaskForEachPart() throws InterruptedException {
        ParticleSystem cloth = cloth();
        ParallelForces.use(cloth.getForceSum(), 3);
        RK4Solver solver = new RK4Solver();
        int others = ForkJoinPool.getCommonPoolParallelism();
        CountDownLatch held = new CountDownLatch(others);
        CountDownLatch measured = new CountDownLatch(1);
        for (int i = 0; i < others; i++) {
            ForkJoinPool.commonPool().submit(() -> {
                held.countDown();
                return measured.await(1, TimeUnit.MINUTES);
            });
        }
        held.await();
        try {
            Steps.make(STEPS, solver, cloth, 1.0 / 1024);
            long bytes = Steps.allocatedIn(STEPS, solver, cloth, 1.0 / 1024);
            // Measured 0 beyond the tasks; the smallest object, 16 bytes, for each evaluation would be 1,280.
            int tasks = 2 * 3 * 4 * STEPS;      // two threads, three times in each evaluation
            assertBelow(16 * 4 * STEPS, bytes - 24 * tasks);
        } finally {
            measured.countDown();
        }
    }

    /** A force that fails on one particle. The caller, which begins with particle 0, awaits that of another thread. */
    private record Failing(AtomicInteger particle, CountDownLatch failed) implements PerParticleEffect {
        @Override
        public String getName() {
            return "failing";
        }

        @Override
        public void addForces(double[] state, double time, double[] force, int from, int to) {
            if (particle.get() >= from && particle.get() < to) {
                failed.countDown();
                throw new ArithmeticException("particle " + particle);
            }
            try {
                assertTrue(from > 0 || particle.get() < 0 || failed.await(1, TimeUnit.MINUTES));
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1800, 3599})
    void aFailureInAnyThreadReachesTheCallerAndTheNextEvaluationWorks(int particle) {
        assumeTrue(particle == 0 || ForkJoinPool.getCommonPoolParallelism() > 0);
        ParticleSystem cloth = cloth();
        Failing failing = new Failing(new AtomicInteger(particle), new CountDownLatch(1));
        cloth.addEffect(failing);
        ParallelForces.use(cloth.getForceSum(), 3);
        double[] dSdt = new double[cloth.getStateSize()];
        assertEquals("particle " + particle,
                assertThrows(ArithmeticException.class, () -> cloth.getStateDerivative(dSdt)).getMessage());
        failing.particle.set(-1);
        cloth.getStateDerivative(dSdt);
        double[] expected = new double[cloth.getStateSize()];
        cloth().getStateDerivative(expected);
        assertArrayEquals(expected, dSdt);
    }
}
