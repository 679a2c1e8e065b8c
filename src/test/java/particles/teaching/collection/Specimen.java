package particles.teaching.collection;

import deSolvers.DESolver;
import java.util.function.Supplier;
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.PlantedSolvers.Step;

/**
 * One solver of the collection.
 *
 * @param name  what its class is called
 * @param about what it is, or what is wrong with it
 * @param cause words, as a regular expression, that the report of a wrong one has to contain; empty for a right one
 * @param maker makes a new one
 */
record Specimen(String name, String about, String cause, Supplier<DESolver> maker) {

    static Specimen right(String name, String about, Supplier<DESolver> maker) {
        return new Specimen(name, about, "", maker);
    }

    static Specimen right(String name, String about, Step step) {
        return right(name, about, () -> PlantedSolvers.solver(step));
    }

    static Specimen wrong(String name, String about, String cause, Supplier<DESolver> maker) {
        return new Specimen(name, about, cause, maker);
    }

    static Specimen wrong(String name, String about, String cause, Step step) {
        return wrong(name, about, cause, () -> PlantedSolvers.solver(step));
    }
}
