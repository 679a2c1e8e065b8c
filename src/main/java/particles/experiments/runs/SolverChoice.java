package particles.experiments.runs;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.Set;
import particles.scene.format.SolverDescription.Tolerances;
import particles.view.Look;

/**
 * A solver in an experiment: a name, and its catalogue entry if it has one.
 *
 * @param name its name in the catalogue, or the class of one's own
 * @param info its catalogue entry; empty for a class of one's own
 */
public record SolverChoice(String name, Optional<SolverInfo> info) {
    /** The solver for whatever is only to be accurate enough. */
    public static final SolverChoice RK4 = of("rk4");
    /** The solver that makes references. */
    public static final SolverChoice ACCURATE = of("dormand-prince");

    /**
     * @param name a catalogue name, or a fully-qualified class name
     * @return the choice
     * @throws NoSuchElementException   if there is no such solver
     * @throws IllegalArgumentException if it cannot be made
     */
    public static SolverChoice of(String name) {
        SolverCatalog.create(name);
        return new SolverChoice(name, SolverCatalog.names().contains(name) ? Optional.of(SolverCatalog.info(name))
                : Optional.empty());
    }

    /**
     * @param names solver names separated by commas; {@code all} is the whole catalogue
     * @return the choices
     * @throws NoSuchElementException   if there is no solver of one of these names
     * @throws IllegalArgumentException if one cannot be made or appears twice, or there is none
     */
    public static List<SolverChoice> list(String names) {
        if (names.strip().equals("all")) {
            return SolverCatalog.names().stream().map(SolverChoice::of).toList();
        }
        List<SolverChoice> choices = separated(names).stream().map(SolverChoice::of).toList();
        if (choices.isEmpty()) {
            throw new IllegalArgumentException("no solver is named");
        }
        return choices;
    }

    /**
     * @return the names in a list separated by commas
     * @throws IllegalArgumentException if one is there twice
     */
    public static List<String> separated(String names) {
        Set<String> once = new LinkedHashSet<>();
        for (String name : names.split(",")) {
            if (!name.isBlank() && !once.add(name.strip())) {
                throw new IllegalArgumentException("'" + name.strip() + "' appears twice");
            }
        }
        return List.copyOf(once);
    }

    /** @return whether it chooses its own sub-steps and takes tolerances */
    public boolean adaptive() {
        return info.isPresent() && info.get().adaptive();
    }

    /** @return whether it solves equations in each step, so that evaluations are not all its work */
    public boolean implicit() {
        return info.isPresent() && info.get().implicit();
    }

    /** @return its order; NaN where it is not known */
    public double order() {
        return info.map(known -> (double) known.order()).orElse(Double.NaN);
    }

    /** @return its name in charts; for a class without the package */
    public String label() {
        return info.isPresent() ? name : name.substring(name.lastIndexOf('.') + 1);
    }

    /** @return its look in charts */
    public Look look() {
        return info.map(Look::of).orElse(Look.OWN);
    }

    /**
     * @param tolerance the relative and absolute tolerance of an adaptive solver; others ignore it
     * @return a solver
     */
    public DESolver create(double tolerance) {
        Tolerances both = Tolerances.both(tolerance);
        return adaptive() ? SolverCatalog.create(name, both.relative(), both.absolute()) : SolverCatalog.create(name);
    }
}
