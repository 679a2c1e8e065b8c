package particles.scene;

import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import particles.effects.AirDrag;
import particles.effects.springs.SpringRates;
import particles.law.Effect;
import particles.law.Particles;

/** The longest stable step of each solver for a scene's springs, their damping and air drag. */
final class StepLimit {
    /** The advised fraction of the stability limit: between the two axes a region can be narrower (RK4's by 8 %). */
    private static final double SAFETY = 0.9;
    /**
     * For solvers that treat damping by fixed-point iteration, such as verlet: the product of step and rate for fast
     * convergence.
     */
    private static final double FIXED_POINT = 0.5;

    private final Scene scene;
    private final SpringRates rates;
    private final double deltaT;
    private final double damping;
    private final double fastest;

    StepLimit(Scene scene) {
        this.scene = scene;
        rates = SpringRates.of(scene.springs(), scene.system().getParticles());
        deltaT = scene.simulation().getDeltaT();
        double drag = dragRate();
        damping = rates.dampingRate() + drag;
        fastest = rates.fastest(drag);
    }

    /** Whether any spring has an end that can move. */
    boolean hasSprings() {
        return rates.stiffest() >= 0;
    }

    /** Whether springs, damping or drag limit a step at all. */
    boolean isKnown() {
        return fastest > 0;
    }

    boolean isDamped() {
        return damping > 0;
    }

    /** Whether every step gains energy, or all but very short ones. */
    boolean alwaysGrows(SolverInfo solver) {
        return limit(solver) == 0 && isKnown();
    }

    boolean isExceededBy(SolverInfo solver) {
        return isKnown() && !(deltaT <= stableStep(solver));
    }

    /** A step below the solver's limit, whatever the springs do (s). */
    double stableStep(SolverInfo solver) {
        if (Double.isNaN(solver.realLimit())) {
            return Math.min(SAFETY * limit(solver) / rates.omega(), FIXED_POINT / damping);
        }
        return SAFETY * limit(solver) / fastest;
    }

    /** Undamped springs lie on the imaginary axis; damping moves them to the real one, where the limit may differ. */
    private double limit(SolverInfo solver) {
        return solver.limit(fastest > rates.omega());
    }

    /** By how much deltaT is too long, for which spring, and the two numbers that this comes from. */
    String excess(SolverInfo solver) {
        Particles particles = scene.system().getParticles();
        int s = rates.stiffest();
        String spring = s < 0 ? "" : "; stiffest spring: '" + particles.id(scene.springs().from(s)) + "' to '"
                + particles.id(scene.springs().to(s)) + "'";
        double limit = limit(solver);
        boolean iterates = Double.isNaN(solver.realLimit());            // for damping, which it solves for apart
        double rate = iterates ? rates.omega() : fastest;
        return "deltaT is too long for the fastest " + (iterates && FIXED_POINT / damping < limit / rate
                ? "damping" + by(deltaT * damping / FIXED_POINT) + "c/m * deltaT is at most "
                        + Digits.few(damping * deltaT) + "; the iteration of " + solver.name()
                        + " converges well up to " + FIXED_POINT
                : "vibration" + by(deltaT * rate / limit) + "|lambda| * deltaT is at most "
                        + Digits.few(deltaT * rate) + "; the limit of " + solver.name() + " is " + Digits.few(limit)
                        + (iterates && damping > 0 ? ", less with damping" : "")) + spring + ")";
    }

    private static String by(double times) {
        return ", by a factor of up to " + Digits.few(times) + " (";
    }

    /** The fastest decay by air drag, c/m (1/s). */
    private double dragRate() {
        double rate = 0;
        for (Effect effect : scene.system().getEffects()) {
            if (effect instanceof AirDrag drag) {
                for (int i = 0; i < scene.system().getParticles().count(); i++) {
                    double inverseMass = scene.system().getParticles().getInverseMasses()[i];
                    rate = Math.max(rate, drag.getSlowCoefficient() * inverseMass);
                }
            }
        }
        return rate;
    }
}
