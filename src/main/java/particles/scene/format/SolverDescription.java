package particles.scene.format;

import deSolvers.DESolver;
import deSolvers.adaptive.AdaptiveSolver;
import deSolvers.catalog.SolverCatalog;
import java.util.NoSuchElementException;
import java.util.Optional;
import particles.spec.ClassNames;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/**
 * The solver of a scene.
 *
 * @param name       its name in the catalogue, or the class of one's own
 * @param tolerances its tolerances, if they are given
 */
public record SolverDescription(String name, Optional<Tolerances> tolerances) {
    public static final Key<String> NAME = NameType.or("solver", SolverCatalog.names(),
            ClassNames.form("exercises.MySolver"))
            .required("name", "The method that solves the equations of motion.");
    private static final Key<Double> RELATIVE = NumberType.between(0, AdaptiveSolver.LOOSEST_TOLERANCE, "")
            .optional("relativeTolerance",
            """
                    1e-6 by default. An adaptive solver divides deltaT into sub-steps so short that the estimated \
                    error of each entry of the state stays below absoluteTolerance + relativeTolerance |entry|. Here \
                    |entry| is the larger of its sizes before and after the sub-step.""");
    private static final Key<Double> ABSOLUTE = NumberType.notNegative("").optional("absoluteTolerance",
            "1e-9 by default (in m and m/s). See relativeTolerance.");

    static final MappingType TYPE = MappingType.of("the solver", NAME, RELATIVE, ABSOLUTE).shortFor(NAME);

    /**
     * The tolerances of an adaptive solver.
     *
     * @param relative error in a sub-step, relative to the size of the state
     * @param absolute error allowed in addition (m, m/s)
     */
    public record Tolerances(double relative, double absolute) {
        /**
         * One tolerance for both.
         *
         * @param tolerance the absolute one; also the relative one, as far as solvers accept it
         * @return both
         */
        public static Tolerances both(double tolerance) {
            return new Tolerances(Math.min(tolerance, AdaptiveSolver.LOOSEST_TOLERANCE), tolerance);
        }
    }

    /**
     * @return a new solver
     * @throws NoSuchElementException   if there is no such solver
     * @throws IllegalArgumentException if it cannot be created
     */
    public DESolver create() {
        return tolerances.isEmpty() ? SolverCatalog.create(name)
                : SolverCatalog.create(name, tolerances.get().relative(), tolerances.get().absolute());
    }

    /** @return the solver with these values, which have no problem */
    static SolverDescription of(Values values) {
        return new SolverDescription(values.get(NAME), values.isGiven(RELATIVE) || values.isGiven(ABSOLUTE)
                ? Optional.of(new Tolerances(values.find(RELATIVE).orElse(1e-6), values.find(ABSOLUTE).orElse(1e-9)))
                : Optional.empty());
    }

    /** @return the values of which {@link #of} makes this solver, as if they stood at this place */
    Values values(Place place) {
        Values named = new Values(place).with(NAME, name, place);
        return tolerances.map(both -> named.with(RELATIVE, both.relative, place).with(ABSOLUTE, both.absolute, place))
                .orElse(named);
    }

    /** Adds a problem if these values give tolerances to a solver that has none. */
    public static void checkTolerances(Values values, Problems problems) {
        SolverDescription solver = of(values);
        if (solver.tolerances.isPresent()
                && SolverCatalog.find(solver.name).filter(known -> !known.adaptive()).isPresent()) {
            problems.add(values.place(values.isGiven(RELATIVE) ? RELATIVE : ABSOLUTE), "solver '" + solver.name
                    + "' takes steps of deltaT and has no tolerances; solvers with"
                    + " tolerances: " + String.join(", ", SolverCatalog.names().stream()
                            .filter(known -> SolverCatalog.info(known).adaptive()).toList()));
        }
    }

    /** Adds a problem if the scene's solver cannot be created. */
    public static void check(SceneDescription scene, Problems problems) {
        try {
            scene.solving().create();
        } catch (NoSuchElementException | IllegalArgumentException e) {
            problems.add(scene.values().place(SceneFormat.SOLVER), e.getMessage());
        }
    }
}
