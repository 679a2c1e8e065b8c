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

/**
 * A solver in an experiment: a name, and its catalogue entry if it has one.
 *
 * @param name its name in the catalogue, or the class of one's own
 * @param info its catalogue entry; empty for a class of one's own
 */
public record SolverChoice(String name, Optional<SolverInfo> info) {
    /** The solver for whatever is only to be accurate enough. */
    public static final SolverChoice RK4 = of("rk4");
    private static final int MOST_NAMED = 3;
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

    /** @return the names as in a sentence: a, b and c */
    public static String together(List<String> names) {
        int last = names.size() - 1;
        return last == 0 ? names.get(0) : String.join(", ", names.subList(0, last)) + " and " + names.get(last);
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

    /** @return the names as in a sentence, or only their number if they are more than three */
    public static String few(List<String> names) {
        return names.size() > MOST_NAMED ? names.size() + " solvers" : together(names);
    }

    /** @return what one solver or several do: "is never stable", "are never stable" */
    public static String verb(int solvers, String does) {
        return solvers == 1 ? does : does.replaceFirst("^is ", "are ").replaceFirst("^(\\w+)s ", "$1 ");
    }

    /** @return all names, and what they do */
    public static String all(List<String> names, String does) {
        return together(names) + " " + verb(names.size(), does);
    }

    /** @return a few names, or their number, and what they do; empty for no names */
    public static String said(List<String> names, String does) {
        return names.isEmpty() ? "" : few(names) + " " + verb(names.size(), does);
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

    /**
     * @param tolerance the relative and absolute tolerance of an adaptive solver; others ignore it
     * @return a solver
     */
    public DESolver create(double tolerance) {
        Tolerances both = Tolerances.both(tolerance);
        return adaptive() ? SolverCatalog.create(name, both.relative(), both.absolute()) : SolverCatalog.create(name);
    }
}
