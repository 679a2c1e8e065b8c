package particles.messages;

import deSolvers.DESolverException;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.function.UnaryOperator;
import particles.BlowUpException;
import particles.NumericalErrorException;
import particles.SimulationException;
import particles.effects.LinearDrag;
import particles.experiments.stability.SpringRates;
import particles.law.Effect;
import particles.law.Particles;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;
import particles.scene.Scene;
import particles.spec.NumberType;

/**
 * The message for a run that cannot go on, in three lines: the event and its place; if springs are the cause, the
 * factor by which deltaT is too long for them; and what to try.
 */
public final class BlowUpMessage {
    /** The advised fraction of the stability limit: between the two axes a region can be narrower (RK4's by 8 %). */
    private static final double SAFETY = 0.9;
    /**
     * For solvers that treat damping by fixed-point iteration, such as verlet: the product of step and rate for fast
     * convergence.
     */
    private static final double FIXED_POINT = 0.5;
    private static final String STEADY = "verlet";
    private static final String STEADY_WITH_DAMPING = "rk4";
    private static final String ADAPTIVE = "dormand-prince";
    private static final String STIFF = "backward-euler";
    private static final String ACCURATE = "radau";

    private final Scene scene;
    private final UnaryOperator<String> options;
    private final SpringRates rates;
    private final double deltaT;
    private final double damping;
    private final double fastest;

    /**
     * @param scene the scene that was run
     * @param options formats an option of this name as it is typed
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
     * @param e the exception that ended the run
     * @return up to three lines, separated by line feeds: the place, the reason and the remedy
     */
    public String of(SimulationException e) {
        String line = scene.description().solver() + " stopped at t = " + Digits.few(e.getTime()) + " s" + particle(e)
                + ": ";
        if (e.getCause() instanceof DESolverException cause) {
            // the text after "last change" is a guess at the cause; the advice knows more
            return line + cause.getMessage().replaceFirst("^\\S+ at t = \\S+ deltaT = \\S+: ", "")
                    .replaceFirst(" \\(last change .*", "") + advice(true);
        }
        if (e instanceof NumericalErrorException error) {
            return (error.isEarly() ? line : "from t = " + Digits.few(e.getTime()) + " s on the motion by "
                    + scene.description().solver() + " is wrong: ") + e.getMessage() + advice(false);
        }
        return line + (e instanceof BlowUpException ? energy() + advice(false) : e.getMessage()
                + (e.getMessage().startsWith(SimulationException.NO_HEADWAY) ? contacts() : scene.simulation().isOver()
                ? trying(step(Digits.few(deltaT / 10)) + " or " + option("solver", ADAPTIVE)) : ""));
    }

    /** The lines for contacts that open and close without end. */
    private String contacts() {
        boolean everBouncing = scene.system().getReactions().stream().anyMatch(reaction ->
                reaction instanceof RestingContacts contacts && contacts.getSurfaces().stream()
                        .anyMatch(surface -> surface.restSpeed() == 0 && surface.restitution() > 0));
        return everBouncing ? "\nwith restSpeed 0, bounces become ever smaller and never end"
                        + trying("restSpeed: 0.01 in the scene's rule")
                : "\nsprings or friction open and close a contact faster than the motion goes on"
                        + trying("impact: clamp in the scene, which changes contacts only between steps");
    }

    /** @return whether numbers grew without bounds; false if a solver found no solution */
    public static boolean isBlowUp(SimulationException e) {
        return e instanceof BlowUpException || e instanceof NumericalErrorException
                || e.getCause() instanceof DESolverException cause && cause.getEntry() >= 0;
    }

    private String particle(SimulationException e) {
        return e.getParticle() < 0 ? "" : " at particle '" + scene.system().getParticles().id(e.getParticle()) + "'";
    }

    private String energy() {
        double energy = scene.system().getKineticEnergy(scene.system().getOwnState());
        return "the kinetic energy is " + Digits.few(energy) + " J, above the limit of "
                + Digits.few(scene.simulation().getEnergyLimit()) + " J";
    }

    /**
     * The second and the third line: the diagnosis and the remedy.
     *
     * @param unsolved whether the solver found no solution, rather than a wrong one
     */
    private String advice(boolean unsolved) {
        String name = scene.description().solver();
        if (!SolverCatalog.names().contains(name)) {
            return "\nthe stability limit of " + name + " is not known"
                    + trying(step(Digits.few(deltaT / 10)));
        }
        SolverInfo solver = SolverCatalog.info(name);
        if (solver.adaptive()) {
            return "\n" + name + " chooses its own sub-steps, so another deltaT does not help"
                    + trying(option("solver", STIFF));
        }
        double limit = limit(solver);
        if (limit == Double.POSITIVE_INFINITY && rates.stiffest() < 0) {
            return "\n" + name + " has no stability limit, but deltaT is too long for forces that change so fast"
                    + trying(option("solver", ADAPTIVE) + ", which chooses its own sub-steps");
        }
        if (limit == 0 && fastest > 0) {
            return "\n" + (damping == 0 ? "undamped springs gain energy with " + name + " at any deltaT"
                    : "springs with little damping gain energy with " + name + " unless deltaT is very short")
                    + trying(withStep(SolverCatalog.info(damping == 0 ? STEADY : STEADY_WITH_DAMPING)));
        }
        if (limit == Double.POSITIVE_INFINITY) {
            return "\n" + name + " has no stability limit, but " + (unsolved && name.equals(STIFF)
                    ? "equations that it could not solve" : "it adds energy where springs buckle")
                    + trying(option("solver", name.equals(STIFF) ? ACCURATE : STIFF));
        }
        return fastest == 0 || deltaT <= stableStep(solver)
                ? "\n" + notSprings(name) + trying(option("solver", ADAPTIVE) + ", which chooses its own sub-steps")
                : "\n" + tooLong(solver, limit) + trying(step(Digits.roundedDown(stableStep(solver))));
    }

    private String notSprings(String name) {
        if (scene.system().getReactions().stream().anyMatch(RigidConstraints.class::isInstance)) {
            return "no spring is too stiff for this deltaT, but what turns fast on rods or wires needs shorter steps";
        }
        return fastest == 0 ? "without springs, it is not known how long deltaT may be"
                : "springs are not the cause: deltaT is within the limit of " + name;
    }

    private static String trying(String what) {
        return "\ntry " + what;
    }

    /** By how much, for which spring, and the two numbers that this comes from. */
    private String tooLong(SolverInfo solver, double limit) {
        Particles particles = scene.system().getParticles();
        int s = rates.stiffest();
        String spring = s < 0 ? "" : "; stiffest spring: '" + particles.id(scene.springs().from(s)) + "' to '"
                + particles.id(scene.springs().to(s)) + "'";
        boolean byFixedPoint = Double.isNaN(solver.realLimit()) && FIXED_POINT / damping < limit / rates.omega();
        double times = byFixedPoint ? deltaT * damping / FIXED_POINT : deltaT * rate(solver) / limit;
        String kind = byFixedPoint ? "damping" : "vibration";
        String what = byFixedPoint
                ? "c/m * deltaT is at most " + Digits.few(damping * deltaT) + "; the iteration of "
                        + solver.name() + " converges well up to " + FIXED_POINT
                : "|lambda| * deltaT is at most " + Digits.few(deltaT * rate(solver)) + "; the limit of "
                        + solver.name() + " is " + Digits.few(limit)
                        + (Double.isNaN(solver.realLimit()) && damping > 0 ? ", less with damping" : "");
        return "deltaT is too long for the fastest " + kind + ", by a factor of up to " + Digits.few(times) + " ("
                + what + spring + ")";
    }

    /** The fastest motion that counts for this solver (1/s): with damping, unless that is solved for apart. */
    private double rate(SolverInfo solver) {
        return Double.isNaN(solver.realLimit()) ? rates.omega() : fastest;
    }

    private String withStep(SolverInfo solver) {
        return option("solver", solver.name()) + (deltaT <= stableStep(solver) ? ""
                : " with " + step(Digits.roundedDown(stableStep(solver))) + ", or "
                        + option("solver", STIFF));
    }

    /** A step below the solver's limit, whatever the springs do (s). */
    private double stableStep(SolverInfo solver) {
        if (Double.isNaN(solver.realLimit())) {
            return Math.min(SAFETY * limit(solver) / rates.omega(), FIXED_POINT / damping);
        }
        return SAFETY * limit(solver) / fastest;
    }

    /** Undamped springs lie on the imaginary axis; damping moves them to the real one, where the limit may differ. */
    private double limit(SolverInfo solver) {
        boolean damped = fastest > rates.omega() && !Double.isNaN(solver.realLimit());
        return damped ? Math.min(solver.realLimit(), solver.imaginaryLimit()) : solver.imaginaryLimit();
    }

    /** An option that is not refused. */
    private String step(String seconds) {
        return Double.parseDouble(seconds) >= NumberType.TINY ? option("deltaT", seconds)
                : "softer springs or larger masses, as no deltaT may be below " + Digits.few(NumberType.TINY) + " s";
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
