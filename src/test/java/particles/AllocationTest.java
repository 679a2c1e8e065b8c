package particles;

import static deSolvers.problems.Bounds.assertBelow;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.effects.AirDrag;
import particles.effects.Cohesion;
import particles.effects.Penalty;
import particles.effects.PointAttraction;
import particles.effects.Wind;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;

/** No solver that steps by deltaT allocates in a step of particles; {@link deSolvers.DESolverContract} tests others. */
class AllocationTest {
    private static final int STEPS = 400;

    /** Wind that grows with time; it uses no StrictMath.cos, which allocates from JDK 21 on. */
    private static final Wind RISING_AIR = (state, time, wind, from, to) -> Arrays.fill(wind, 6 * from, 6 * to, time);

    static List<String> fixedStepSolvers() {
        return SolverCatalog.all().stream().filter(solver -> !solver.adaptive()).map(SolverInfo::name).toList();
    }

    /**
     * Measured 0 to 1,104 bytes (by the measurement itself and the compiler); one boxed number a step would be 6,400.
     */
    private static void assertNothing(DESolver solver, DEStateSource source, double deltaT) {
        Steps.make(STEPS, solver, source, deltaT);
        long bytes = Steps.allocatedIn(STEPS, solver, source, deltaT);
        assertBelow(4000, bytes);
    }

    @ParameterizedTest
    @MethodSource("fixedStepSolvers")
    void aStepOfAClothWithEveryKindOfEffectAllocatesNothing(String solver) {
        ParticleSystem cloth = Cloth.hanging(6, 20, 0.02);
        Particles particles = cloth.getParticles();
        cloth.addEffect(AirDrag.linear(particles, 0.01, Wind.STILL));
        cloth.addEffect(AirDrag.quadratic(particles, 0.01, RISING_AIR));
        cloth.addEffect(new PointAttraction(particles, Vector3.ZERO, 0.1, 0.1));
        cloth.addEffect(new Penalty(particles, new Plane(new Vector3(0, -0.2, 0), new Vector3(0, 1, 0)), 10, 0.1));
        cloth.addEffect(new Penalty(particles, new Sphere(Vector3.ZERO, 0.2, false), 10, 0.1));
        // whose matrix changes its pattern with the neighbours
        if (!SolverCatalog.info(solver).implicit()) {
            cloth.addEffect(new Cohesion(particles, 0.1, 0.05, 1e-4, 1e-3));
        }
        assertNothing(SolverCatalog.create(solver), cloth, 1.0 / 1024);
    }

    @ParameterizedTest
    @MethodSource("fixedStepSolvers")
    void aStepOfAChainAllocatesNothing(String solver) {
        assertNothing(SolverCatalog.create(solver), Cloth.chain(20, 1, 1, 100, 0), 1.0 / 256);
    }
}
