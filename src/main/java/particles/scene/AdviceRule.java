package particles.scene;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.spec.NumberType;

/**
 * The one rule by which a run that failed is advised.
 * <ol>
 * <li>Springs too fast for deltaT: a step that the solver takes stably, or verlet or rk4 in place of one that takes
 *     none, if all that costs at most {@value #MOST} times what the run would have cost.</li>
 * <li>Springs too stiff for that: an implicit solver. {@code radau} is accurate whatever the springs do, but takes
 *     hundreds of evaluations per step, so it is for small scenes; {@code linearised-euler} solves one linear system
 *     per step, which cannot fail to converge, and damps.</li>
 * <li>Other forces, rods and wires: a solver that chooses its own sub-steps.</li>
 * <li>Friction that turns within a step: a solver that steps across the turn.</li>
 * <li>Contacts that open and close without end: impacts at the ends of steps, or soft balls in place of hard ones.</li>
 * </ol>
 * No solver is advised that has just failed, except with a shorter step.
 */
final class AdviceRule {
    private static final String UNDAMPED = "verlet";
    private static final String DAMPED = "rk4";
    private static final String ADAPTIVE = "dormand-prince";
    private static final String STIFF = "linearised-euler";
    private static final String STIFF_AND_ACCURATE = "radau";

    /** The largest cost of what is advised, relative to what the run would have cost. */
    static final double MOST = 10;
    /** Evaluations times particles that are over at once, whatever the run would have cost: about 0.1 s. */
    static final double LITTLE = 1e6;
    /** Iterations by which symplectic solvers find the velocity at the end of an advised step, with damping. */
    private static final double ITERATIONS = 13;
    /** Evaluations per step of radau on stiff springs: 340 on a double pendulum, 460 on a curtain. */
    private static final double STIFF_EVALUATIONS = 500;
    /** By how much a step is shortened for a solver of unknown limit, and for linearised steps in a turning spring. */
    private static final double MUCH = 10;
    private static final double SOME = 4;
    /** A smaller factor of cost is not worth a word. */
    private static final double NOTEWORTHY = 1.5;

    private final UnaryOperator<String> options;
    private final StepLimit limits;
    private final String failed;
    private final boolean hardBalls;
    private final double deltaT;
    private final double steps;
    private final double particles;
    private final double made;                          // evaluations per step of the failed run; 0 without a step

    /**
     * @param scene   the scene as the failed run left it
     * @param options formats an option of this name as it is typed
     */
    AdviceRule(Scene scene, StepLimit limits, UnaryOperator<String> options) {
        this.options = options;
        this.limits = limits;
        failed = scene.description().solver();
        hardBalls = scene.description().hasHardBalls();
        deltaT = scene.simulation().getDeltaT();
        steps = Math.ceil(scene.simulation().getDuration() / deltaT);
        particles = Math.max(1, scene.system().getParticles().count());
        made = scene.simulation().getSteps() == 0 ? 0
                : (double) scene.system().getEvaluations() / scene.simulation().getSteps();
    }

    /** For springs that are too fast for this solver at this deltaT. */
    String forSprings(SolverInfo solver) {
        List<SolverInfo> steppers = new ArrayList<>();
        if (!limits.alwaysGrows(solver)) {
            steppers.add(solver);
        }
        if (limits.isDamped() || steppers.isEmpty()) {
            steppers.add(SolverCatalog.info(limits.isDamped() ? DAMPED : UNDAMPED));
        }
        for (SolverInfo stepper : steppers) {
            double step = Math.min(deltaT, limits.stableStep(stepper));
            if (step < NumberType.TINY) {
                return byHand("softer springs or larger masses, as no deltaT may be below "
                        + Digits.few(NumberType.TINY) + " s");
            }
            double evaluations = steps * deltaT / step * evaluationsPerStep(stepper);
            double cost = evaluations / (steps * (made > 0 ? made : evaluationsPerStep(solver)));
            if (cost <= MOST || evaluations * particles <= LITTLE) {
                return advice(Optional.of(stepper.name()).filter(name -> !name.equals(failed)), shorter(step),
                        cost < NOTEWORTHY ? "" : "which takes about " + Digits.few(Math.ceil(cost))
                                + " times the work");
            }
        }
        return forStiffness();
    }

    /** At most: an explicit solver's order; of a symplectic one, one less, and with damping some iterations. */
    private double evaluationsPerStep(SolverInfo solver) {
        return solver.secondOrder() ? Math.max(1, solver.order() - 1) * (limits.isDamped() ? ITERATIONS : 1)
                : solver.order();
    }

    /** For springs that no explicit solver can follow, or that an implicit solver could not solve. */
    String forStiffness() {
        boolean small = steps * STIFF_EVALUATIONS * particles <= LITTLE;
        if (failed.equals(STIFF) && !small) {
            return advice(Optional.empty(), shorter(deltaT / SOME),
                    "in which springs turn less, with " + Digits.few(SOME) + " times the work");
        }
        return failed.equals(STIFF_AND_ACCURATE) || !small
                ? ofSolver(STIFF, "which solves one linear system per step and damps what is too fast for it")
                : ofSubSteps(STIFF_AND_ACCURATE);
    }

    /** For what is not the springs' doing. */
    String forOtherForces() {
        return failed.equals(ADAPTIVE) ? ofSolver(DAMPED, "") : ofSubSteps(ADAPTIVE);
    }

    /** For friction whose direction turns within a step. */
    String forFriction() {
        SolverInfo across = SolverCatalog.info(DAMPED);
        return advice(Optional.of(DAMPED), shorter(Math.min(deltaT, limits.stableStep(across))),
                "which steps across the change");
    }

    /**
     * For contacts that open and close without end. Hard balls only have exact impacts, so soft ones take their place.
     * Between exact impacts, pieces of steps were short enough for any solver; whole steps have to be stable.
     */
    String forContacts() {
        if (hardBalls) {
            return byHand("the effect 'repulsion', with soft balls, in place of 'collisions'");
        }
        double step = SolverCatalog.find(failed).filter(solver -> !solver.adaptive() && !limits.alwaysGrows(solver))
                .map(limits::stableStep).orElse(deltaT);
        return advice(Optional.empty(), Stream.concat(shorter(Math.min(deltaT, step)),
                Stream.of("impact: clamp in the scene")), "which changes contacts only between steps");
    }

    /** For a solver of which nothing is known. */
    String forUnknown() {
        return advice(Optional.empty(), shorter(deltaT / MUCH), "");
    }

    private String ofSubSteps(String name) {
        return ofSolver(name, "which chooses its own sub-steps");
    }

    private String ofSolver(String name, String note) {
        return advice(Optional.of(name), Stream.empty(), note);
    }

    /** For what no option changes. */
    static String byHand(String what) {
        return "try " + what;
    }

    /**
     * The sentence that begins with "try".
     *
     * @param solver another solver, if one is needed
     * @param more   what else to change
     * @param note   what that costs or does; may be empty
     */
    private String advice(Optional<String> solver, Stream<String> more, String note) {
        String what = Stream.concat(solver.map(name -> options.apply("solver") + "=" + name).stream(), more)
                .collect(Collectors.joining(" with "));
        return byHand(what + (what.isEmpty() || note.isEmpty() ? "" : ", ") + note);
    }

    /** The option for a step, rounded down to a few digits; none if it is deltaT itself. */
    private Stream<String> shorter(double step) {
        return step < deltaT ? Stream.of(options.apply("deltaT") + "="
                + Digits.exact(Double.parseDouble(Digits.roundedDown(step, 2)))) : Stream.empty();
    }
}
