package benchmarks;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import java.util.Map;
import org.hipparchus.ode.ODEIntegrator;
import org.hipparchus.ode.nonstiff.AdamsMoultonIntegrator;
import org.hipparchus.ode.nonstiff.ClassicalRungeKuttaIntegrator;
import org.hipparchus.ode.nonstiff.DormandPrince54Integrator;
import org.hipparchus.ode.nonstiff.EulerIntegrator;
import org.hipparchus.ode.nonstiff.GraggBulirschStoerIntegrator;
import org.hipparchus.ode.nonstiff.MidpointIntegrator;
import particles.scene.format.SolverDescription.Tolerances;

/** One of our solvers or of Hipparchus' integrators, applied to a workload. */
interface Method {
    /** Integrators with a fixed step. */
    Map<String, Fixed> HIPPARCHUS_FIXED = Map.of("Euler", EulerIntegrator::new, "Midpoint", MidpointIntegrator::new,
            "ClassicalRungeKutta", ClassicalRungeKuttaIntegrator::new);
    /** Adaptive integrators. Adams-Moulton with three steps has order 4, as ours. */
    Map<String, Adaptive> HIPPARCHUS_ADAPTIVE = Map.of("DormandPrince54", DormandPrince54Integrator::new,
            "GraggBulirschStoer", GraggBulirschStoerIntegrator::new, "AdamsMoulton",
            (least, most, absolute, relative) -> new AdamsMoultonIntegrator(3, least, most, absolute, relative));
    double SHORTEST = 1e-12;

    /** Makes an integrator. */
    interface Fixed {
        ODEIntegrator create(double step);
    }

    /** Makes an integrator. */
    interface Adaptive {
        ODEIntegrator create(double shortest, double longest, double absoluteTolerance, double relativeTolerance);
    }

    /** Solves the workload from its start. */
    void solve(Workload workload);

    /**
     * Makes a method with steps of equal length; its solver is reused for repeated runs.
     *
     * @param name     a solver of our catalogue, one of {@link #HIPPARCHUS_FIXED}, or one of {@link ByHand}
     * @param duration the simulated time (s)
     */
    static Method withSteps(String name, Workload workload, double duration, int steps) {
        if (name.endsWith(ByHand.SUFFIX)) {
            return new ByHand(name, workload, duration, steps);
        }
        return HIPPARCHUS_FIXED.containsKey(name)
                ? hipparchus(HIPPARCHUS_FIXED.get(name).create(duration / steps), duration)
                : ours(SolverCatalog.create(name), duration, steps);
    }

    /**
     * Makes an adaptive method.
     *
     * @param name      a solver of our catalogue, or one of {@link #HIPPARCHUS_ADAPTIVE}
     * @param duration  the simulated time (s)
     * @param tolerance relative and absolute tolerance
     */
    static Method withTolerance(String name, double duration, double tolerance) {
        Tolerances both = Tolerances.both(tolerance);
        return HIPPARCHUS_ADAPTIVE.containsKey(name)
                ? hipparchus(HIPPARCHUS_ADAPTIVE.get(name).create(SHORTEST, duration, tolerance, tolerance), duration)
                : ours(SolverCatalog.create(name, both.relative(), both.absolute()), duration, 1);
    }

    private static Method ours(DESolver solver, double duration, int steps) {
        return workload -> {
            workload.restart();
            for (int n = 0; n < steps; n++) {
                solver.stepState(workload.source(), duration / steps);
            }
        };
    }

    private static Method hipparchus(ODEIntegrator integrator, double duration) {
        return workload -> {
            workload.restart();
            workload.end(duration, integrator.integrate(workload, workload.start(), duration).getPrimaryState());
        };
    }
}
