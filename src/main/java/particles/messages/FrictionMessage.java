package particles.messages;

import deSolvers.DESolverException;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.Optional;
import java.util.function.UnaryOperator;
import particles.SimulationException;
import particles.experiments.stability.SpringRates;
import particles.reactions.RestingContacts;
import particles.scene.Scene;

/**
 * The message for a step that fails because Coulomb friction changes its direction within it. Near a stop the direction
 * changes as fast as that of the velocity, so a shorter step may not help, and springs and drag are not the cause. An
 * explicit solver steps across the change, and the rule after the step detects the stop.
 */
public final class FrictionMessage {
    private static final String EXPLICIT = "rk4";
    /** The advised fraction of the stability limit, as for other blow-ups. */
    private static final double SAFETY = 0.9;

    private FrictionMessage() {
    }

    /**
     * @param scene the scene that was run, as the exception left it
     * @param options formats an option of this name as it is typed
     * @param e     the exception that ended the run
     * @return three lines, separated by line feeds; empty if friction is not the cause
     */
    public static Optional<String> of(Scene scene, UnaryOperator<String> options, SimulationException e) {
        String name = scene.description().solver();
        if (!(e.getCause() instanceof DESolverException cause) || isBlowUp(name, cause) || !mayStop(scene)) {
            return Optional.empty();
        }
        String found = cause.getMessage().replaceFirst("^\\S+ at t = \\S+ deltaT = \\S+: ", "")
                .replaceFirst("; .*", "");
        return Optional.of(name + " stopped at t = " + Digits.few(e.getTime()) + " s: " + found + "\nsomething"
                + " is about to stop or to begin to slide, and there Coulomb friction changes its direction"
                + " too fast for "
                + name + "\ntry " + options.apply("solver") + "=" + EXPLICIT + step(scene, options)
                + ", which steps across the change");
    }

    /** Numbers of a fixed step may grow without bounds; an adaptive one names the entry that changes too fast. */
    private static boolean isBlowUp(String solver, DESolverException cause) {
        return cause.getEntry() >= 0
                && !(SolverCatalog.names().contains(solver) && SolverCatalog.info(solver).adaptive());
    }

    private static boolean mayStop(Scene scene) {
        return scene.system().getReactions().stream().anyMatch(reaction -> reaction instanceof RestingContacts contacts
                && contacts.mayStopWithin(scene.system(), scene.simulation().getDeltaT()));
    }

    /** A step that the explicit solver can make, if springs need one. */
    private static String step(Scene scene, UnaryOperator<String> options) {
        SolverInfo solver = SolverCatalog.info(EXPLICIT);
        double rate = SpringRates.of(scene.springs(), scene.system().getParticles()).fastest(0);
        double longest = SAFETY * Math.min(solver.realLimit(), solver.imaginaryLimit()) / rate;
        return scene.simulation().getDeltaT() <= longest ? ""
                : " with " + options.apply("deltaT") + "=" + Digits.roundedDown(longest);
    }
}
