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
import particles.scene.format.Tolerances;

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

    /** @return whether the method is adaptive and needs a tolerance */
    static boolean isAdaptive(String name) {
        return HIPPARCHUS_ADAPTIVE.containsKey(name) || SolverCatalog.names().contains(name)
                && SolverCatalog.info(name).adaptive();
    }

    /** Makes the method of a run; its solver is reused for repeated runs. */
    static Method of(Run run) {
        if (ByHand.isMeant(run)) {
            return ByHand.of(run);
        }
        if (HIPPARCHUS_FIXED.containsKey(run.method())) {
            return hipparchus(HIPPARCHUS_FIXED.get(run.method()).create(run.duration() / run.steps()), run.duration());
        }
        if (HIPPARCHUS_ADAPTIVE.containsKey(run.method())) {
            return hipparchus(HIPPARCHUS_ADAPTIVE.get(run.method()).create(SHORTEST, run.duration(), run.tolerance(),
                    run.tolerance()), run.duration());
        }
        Tolerances both = Tolerances.both(run.tolerance());
        DESolver solver = Double.isNaN(run.tolerance()) ? SolverCatalog.create(run.method())
                : SolverCatalog.create(run.method(), both.relative(), both.absolute());
        return workload -> {
            workload.restart();
            for (int n = 0; n < run.steps(); n++) {
                solver.stepState(workload.source(), run.duration() / run.steps());
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
