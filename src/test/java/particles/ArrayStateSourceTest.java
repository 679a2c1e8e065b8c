package particles;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.PlainSource;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.effects.Gravity;
import particles.effects.LinearDrag;
import particles.effects.Wind;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/** A system steps with the same bits whether solvers use its arrays or only the plain interface. */
class ArrayStateSourceTest {

    private static ParticleSystem net() {
        ParticleSystem system = new ParticleSystem();
        Random random = new Random(6);
        for (int i = 0; i < 36; i++) {
            system.addParticle("p" + i, 0.5 + random.nextDouble(), new Vector3(i % 6 + 0.1 * random.nextDouble(), i / 6,
                    0),
                    i == 0 ? Vector3.ZERO : new Vector3(0, 0, random.nextDouble()), i == 0);
        }
        SpringForce springs = new SpringForce(system.getParticles());
        for (int s = 0; s < 160; s++) {
            int i = random.nextInt(36);
            springs.addSpring(i, (i + 1 + random.nextInt(35)) % 36, 20, 1, 0.1);
        }
        system.addEffect(springs);
        system.addEffect(new Gravity(system.getParticles(), Systems.GRAVITY));
        system.addEffect(new LinearDrag(system.getParticles(), 0.1, Wind.STILL));
        return system;
    }

    /** The system without its arrays. */
    private static final class WithoutArrays extends PlainSource implements SecondOrderStateSource {
        WithoutArrays(ParticleSystem system) {
            super(system);
        }

        @Override
        public int getDimension() {
            return 3;
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "symplectic-euler", "verlet", "yoshida4", "dormand-prince",
            "step-doubling", "bulirsch-stoer", "adams"})
    void sameBitsWithAndWithoutArrays(String name) {
        ParticleSystem fast = net();
        ParticleSystem slow = net();
        DESolver fastSolver = SolverCatalog.create(name);
        DESolver slowSolver = SolverCatalog.create(name);
        DEStateSource plain = new WithoutArrays(slow);
        for (int step = 0; step < 25; step++) {
            fastSolver.stepState(fast, 0.01);
            slowSolver.stepState(plain, 0.01);
        }
        assertArrayEquals(slow.getStateArray(), fast.getStateArray());
        assertEquals(slow.getEvaluations(), fast.getEvaluations());
    }
}
