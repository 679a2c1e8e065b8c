package particles;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.PlainSource;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.effects.AirDrag;
import particles.effects.Wind;
import particles.law.AnchorMotion.CircleMotion;
import particles.law.Vector3;

/** A system steps with the same bits whether solvers use its arrays or only the plain interface. */
class ArrayStateSourceTest {

    /** A cloth with drag, one of whose two corners goes round on a crank. */
    private static ParticleSystem cloth() {
        ParticleSystem system = Cloth.hanging(6, 20, 0.01);
        system.addEffect(AirDrag.linear(system.getParticles(), 0.1, Wind.STILL));
        system.moveAnchor(0, new CircleMotion(Vector3.ZERO, new Vector3(0.3, 0, 0), new Vector3(0, 0, 1), 1.5));
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
        ParticleSystem fast = cloth();
        ParticleSystem slow = cloth();
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

    /** A step exchanges arrays with the system; no two systems of a solver may end with the same one. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "rk4", "symplectic-euler", "verlet", "yoshida4"})
    void systemsOfOneSolverStayApart(String name) {
        DESolver shared = SolverCatalog.create(name);
        ParticleSystem first = cloth();
        ParticleSystem second = cloth();
        ParticleSystem alone = cloth();
        for (int step = 0; step < 3; step++) {
            shared.stepState(first, 0.01);
            shared.stepState(second, 0.02);
            SolverCatalog.create(name).stepState(alone, 0.01);
        }
        assertArrayEquals(alone.getStateArray(), first.getStateArray());
    }
}
