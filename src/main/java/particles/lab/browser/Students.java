package particles.lab.browser;

import deSolvers.DESolver;
import java.util.Map;
import java.util.function.Supplier;
import particles.effects.EffectKind;

/**
 * The students' classes that are in the page. This is a page without any; where there are some, {@code PageClasses}
 * compiles another class of this name in its place.
 */
final class Students {
    static final Map<String, Supplier<DESolver>> SOLVERS = Map.of();
    static final Map<String, Supplier<EffectKind>> EFFECTS = Map.of();

    private Students() {
    }
}
