package particles.messages;

import deSolvers.text.Digits;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.scene.format.SceneDescription;

/**
 * What to change in a scene that could not be run to its end. The sentence of a message is made from it, and a test
 * follows it.
 *
 * @param solver another solver, if one is needed
 * @param deltaT another time step (s), if one is needed; with as many digits as are printed
 * @param clamp  whether contacts are to change only between steps
 * @param note   what that costs or does, or what else has to be changed by hand; may be empty
 */
public record Advice(Optional<String> solver, OptionalDouble deltaT, boolean clamp, String note) {

    static Advice ofSolver(String name, String note) {
        return new Advice(Optional.of(name), OptionalDouble.empty(), false, note);
    }

    static Advice byHand(String what) {
        return new Advice(Optional.empty(), OptionalDouble.empty(), false, what);
    }

    /** @return whether {@link #applyTo} changes anything */
    public boolean canBeFollowed() {
        return solver.isPresent() || deltaT.isPresent() || clamp;
    }

    /**
     * @param scene the scene that could not be run
     * @return the same scene as advised
     */
    public SceneDescription applyTo(SceneDescription scene) {
        SceneDescription changed = solver.isPresent() ? scene.withSolver(solver.get()) : scene;
        changed = deltaT.isPresent() ? changed.withDeltaT(deltaT.getAsDouble()) : changed;
        return clamp ? changed.withClampedImpacts() : changed;
    }

    /**
     * @param options formats an option of this name as it is typed
     * @return the sentence that begins with "try"
     */
    String sentence(UnaryOperator<String> options) {
        String step = deltaT.isPresent() ? options.apply("deltaT") + "=" + Digits.exact(deltaT.getAsDouble()) : "";
        String what = Stream.of(solver.map(name -> options.apply("solver") + "=" + name).orElse(""), step,
                clamp ? "impact: clamp in the scene" : "").filter(part -> !part.isEmpty())
                .collect(Collectors.joining(" with "));
        return "try " + what + (what.isEmpty() || note.isEmpty() ? "" : ", ") + note;
    }
}
