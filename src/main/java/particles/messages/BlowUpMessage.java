package particles.messages;

import deSolvers.DESolverException;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.function.UnaryOperator;
import particles.BlowUpException;
import particles.law.Effect;
import particles.law.Particles;
import particles.SimulationException;
import particles.effects.LinearDrag;
import particles.experiments.stability.SpringRates;
import particles.scene.Scene;

/**
 * The line that a run ends with which cannot go on: what happened where and, where a solver or its step is to blame,
 * how fast the springs are beside the time step, and what to try. What rods and contacts cannot do is no question of
 * springs.
 */
public final class BlowUpMessage {
    /** Of the stability limit, what is advised: between the two axes a region can be narrower (RK4's by 8 %). */
    private static final double SAFETY = 0.9;
    /** Where damping is solved for by fixed point, as in verlet, a step times its rate that converges quickly. */
    private static final double FIXED_POINT = 0.5;
    private static final String STEADY = "rk4";
    private static final String STIFF = "backward-euler";

    private final Scene scene;
    private final UnaryOperator<String> options;
    private final SpringRates rates;
    private final double deltaT;
    private final double damping;
    private final double fastest;

    /**
     * @param scene the scene that was run
     * @param options how an option of this name is typed
     */
    public BlowUpMessage(Scene scene, UnaryOperator<String> options) {
        this.scene = scene;
        this.options = options;
        rates = SpringRates.of(scene.springs(), scene.system().getParticles());
        deltaT = scene.simulation().getDeltaT();
        double drag = dragRate();
        damping = rates.dampingRate() + drag;
        fastest = rates.fastest(drag);
    }

    /**
     * @param e what ended the run
     * @return the line
     */
    public String of(SimulationException e) {
        String line = scene.description().solver() + " stopped at t = " + Digits.few(e.getTime()) + " s" + particle(e)
                + ": ";
        if (e.getCause() instanceof DESolverException cause) {
            return line + cause.getMessage().replaceFirst("^\\S+ at t = \\S+ deltaT = \\S+: ",
                    "") + stiffest() + advice();
        }
        return line + (e instanceof BlowUpException ? energy() + stiffest() + advice() : e.getMessage());
    }

    private String particle(SimulationException e) {
        return e.getParticle() < 0 ? "" : " at particle '" + scene.system().getParticles().id(e.getParticle()) + "'";
    }

    private String energy() {
        double energy = scene.system().getKineticEnergy(scene.system().getOwnState());
        return "the kinetic energy is " + Digits.few(energy) + " J, more than the limit of "
                + Digits.few(scene.simulation().getEnergyLimit()) + " J";
    }

    private String stiffest() {
        int s = rates.stiffest();
        if (s < 0) {
            return "; no spring pulls at anything";
        }
        Particles particles = scene.system().getParticles();
        return "; the stiffest spring, from '" + particles.id(scene.springs().from(s)) + "' to '"
                + particles.id(scene.springs().to(s)) + "', has omega*deltaT = " + Digits.few(rates.ownOmega() * deltaT)
                + ", all together at most " + Digits.few(rates.omega() * deltaT)
                + (fastest > rates.omega() ? ", with damping " + Digits.few(fastest * deltaT) : "");
    }

    private String advice() {
        String name = scene.description().solver();
        if (!SolverCatalog.names().contains(name)) {
            return "; the limit of " + name + " is not known: try " + option("deltaT", Digits.few(deltaT / 10));
        }
        SolverInfo solver = SolverCatalog.info(name);
        if (solver.adaptive()) {
            return "; " + name + " chooses its own steps, so try " + option("solver", STIFF);
        }
        double limit = limit(solver);
        if (limit == 0) {
            return "; the limit of " + name + " is 0, its oscillations grow at any step: try "
                    + withStep(SolverCatalog.info(STEADY));
        }
        if (limit == Double.POSITIVE_INFINITY) {
            return "; " + name + " has no limit, but equations to solve"
                    + (name.equals(STIFF) ? ": try " + option("deltaT", Digits.few(deltaT / 2))
                            : ", and where springs buckle it makes energy: try " + option("solver", STIFF));
        }
        String stated = "; the limit of " + name + " is " + Digits.few(limit) + ": try ";
        return deltaT <= stableStep(solver) ? stated + option("deltaT", Digits.few(deltaT / 4))
                + ", as springs are not the cause"
                : stated + option("deltaT", Digits.roundedDown(stableStep(solver)));
    }


    private String withStep(SolverInfo solver) {
        return option("solver", solver.name()) + (deltaT <= stableStep(solver) ? ""
                : " with " + option("deltaT", Digits.roundedDown(stableStep(solver))) + ", or " + option("solver",
                STIFF));
    }

    /** A step below the solver's limit, whatever the springs do (s). */
    private double stableStep(SolverInfo solver) {
        if (Double.isNaN(solver.realLimit())) {
            return Math.min(SAFETY * limit(solver) / rates.omega(), FIXED_POINT / damping);
        }
        return SAFETY * limit(solver) / fastest;
    }

    /**
     * Of undamped springs on the imaginary axis; damping moves towards the real one, where the limit may be smaller.
     */
    private double limit(SolverInfo solver) {
        boolean damped = fastest > rates.omega() && !Double.isNaN(solver.realLimit());
        return damped ? Math.min(solver.realLimit(), solver.imaginaryLimit()) : solver.imaginaryLimit();
    }

    private String option(String name, String value) {
        return options.apply(name) + "=" + value;
    }

    /** The fastest decay by air drag, c/m (1/s). */
    private double dragRate() {
        double rate = 0;
        for (Effect effect : scene.system().getEffects()) {
            if (effect instanceof LinearDrag drag) {
                for (int i = 0; i < scene.system().getParticles().count(); i++) {
                    rate = Math.max(rate, drag.getCoefficient() * scene.system().getParticles().inverseMasses()[i]);
                }
            }
        }
        return rate;
    }
}
