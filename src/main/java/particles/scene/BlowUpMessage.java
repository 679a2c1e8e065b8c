package particles.scene;

import deSolvers.DESolverException;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.SimulationException.End;
import particles.law.Effect;
import particles.reactions.RestingContacts;

/**
 * The message for a run that cannot go on, in up to three lines: the event and its place; the cause, such as the factor
 * by which deltaT is too long for the springs; and what to try, by {@link AdviceRule}.
 */
public final class BlowUpMessage {
    private final Scene scene;
    private final SimulationException end;
    private final Optional<DESolverException> failure;
    private final String solver;
    private final StepLimit limits;
    private final AdviceRule rule;
    private final Optional<Effect> singular;

    /**
     * @param scene   the scene that was run, as the exception left it
     * @param end     the exception that ended the run
     * @param options formats an option of this name as it is typed
     */
    public BlowUpMessage(Scene scene, SimulationException end, UnaryOperator<String> options) {
        this.scene = scene;
        this.end = end;
        failure = end.getCause() instanceof DESolverException given ? Optional.of(given) : Optional.empty();
        solver = scene.description().solver();
        limits = new StepLimit(scene);
        rule = new AdviceRule(scene, limits, options);
        singular = failure.filter(given -> given.getEntry() >= 0).flatMap(given -> singularForce());
    }

    /** @return whether numbers grew without bounds; false if a solver found no solution */
    public boolean isBlowUp() {
        return Set.of(End.ENERGY_LIMIT, End.NUMERICAL_ERROR, End.WRONG_MOTION).contains(end.getEnd())
                || failure.isPresent() && failure.get().getEntry() >= 0;
    }

    /** @return the lines, separated by line feeds */
    public String lines() {
        return Stream.concat(Stream.of(what()), reasons().stream()).collect(Collectors.joining("\n"));
    }

    private String what() {
        String from = "from t = " + Digits.few(end.getTime()) + " s on the motion by " + solver + " is wrong: ";
        if (end.getEnd() == End.WRONG_MOTION) {
            return from + end.getMessage();
        }
        String particle = end.getParticle() < 0 ? ""
                : " at particle '" + scene.system().getParticles().id(end.getParticle()) + "'";
        return solver + " stopped at t = " + Digits.few(end.getTime()) + " s" + particle + ": "
                + singular.map(force -> "the force '" + force.getName() + "' is not finite there")
                        .or(() -> failure.map(DESolverException::getReason))
                        .orElse(end.getMessage());
    }

    /** A force that is not finite at the beginning of the failed step, as beside the point of an attraction. */
    private Optional<Effect> singularForce() {
        ParticleSystem system = scene.system();
        return system.getEffects().stream().filter(effect -> {
            double[] force = new double[system.getStateSize()];
            effect.addForces(system.getOwnState(), system.getTime(), force);
            return !Arrays.stream(force).allMatch(Double::isFinite);
        }).findFirst();
    }

    /** The cause, if it is known, and the advice. */
    private List<String> reasons() {
        Optional<SolverInfo> known = SolverCatalog.find(solver);
        boolean adaptive = known.filter(SolverInfo::adaptive).isPresent();
        if (singular.isPresent()) {
            return List.of("no solver can go on from there", AdviceRule.byHand("other positions in the scene"));
        }
        if (end.getEnd() == End.NO_HEADWAY) {
            return ofContacts();
        }
        if (failure.isPresent() && (adaptive || !isBlowUp()) && mayStop()) {
            return List.of("something is about to stop or to begin to slide, and there Coulomb friction changes its"
                    + " direction too fast for " + solver, rule.forFriction());
        }
        if (failure.isPresent() || isBlowUp()) {
            return known.map(this::ofForces).orElseGet(() ->
                    List.of("the stability limit of " + solver + " is not known", rule.forUnknown()));
        }
        return !scene.simulation().isOver() ? List.of()
                : List.of(adaptive ? rule.forUnknown() : rule.forOtherForces());
    }

    /** Contacts that open and close without end. */
    private List<String> ofContacts() {
        if (scene.description().bouncesForEver()) {
            return List.of("with restSpeed 0, bounces become ever smaller and never end",
                    AdviceRule.byHand("restSpeed: 0.01 in the scene's rule"));
        }
        return List.of((scene.description().hasHardBalls() ? "hard balls meet and part"
                : "springs or friction open and close a contact") + " faster than the motion goes on",
                rule.forContacts());
    }

    private boolean mayStop() {
        return scene.system().getReactions().stream().anyMatch(reaction -> reaction instanceof RestingContacts contacts
                && contacts.getQueries().mayStopWithin(scene.simulation().getDeltaT()));
    }

    private List<String> ofForces(SolverInfo known) {
        if (known.adaptive()) {
            return List.of(solver + " chooses its own sub-steps, so another deltaT does not help",
                    limits.hasSprings() ? rule.forStiffness() : rule.forOtherForces());
        }
        if (known.unlimited()) {
            String but = solver + " has no stability limit, but ";
            String cause = !isBlowUp() ? "its equations could not be solved"
                    : limits.hasSprings() ? "it adds energy where springs buckle or turn"
                    : "deltaT is too long for forces that change so fast";
            return List.of(but + cause, limits.hasSprings() ? rule.forStiffness() : rule.forOtherForces());
        }
        if (limits.alwaysGrows(known)) {
            return List.of(limits.isDamped() ? "springs with little damping gain energy with " + solver
                    + " unless deltaT is very short" : "undamped springs gain energy with " + solver
                    + " at any deltaT", rule.forSprings(known));
        }
        return limits.isExceededBy(known) ? List.of(limits.excess(known), rule.forSprings(known))
                : List.of(limits.isKnown() ? "springs are not the cause: deltaT is within their limit with " + solver
                        : "without springs, it is not known how long deltaT may be", rule.forOtherForces());
    }
}
