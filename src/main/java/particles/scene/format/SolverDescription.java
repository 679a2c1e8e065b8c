package particles.scene.format;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import java.util.NoSuchElementException;
import java.util.Optional;

/**
 * The solver of a scene.
 *
 * @param name       its name in the catalogue, or the class of one's own
 * @param tolerances its tolerances, if they are given
 */
public record SolverDescription(String name, Optional<Tolerances> tolerances) {

    /**
     * @return a new solver
     * @throws NoSuchElementException   if there is no such solver
     * @throws IllegalArgumentException if it cannot be created
     */
    public DESolver create() {
        return tolerances.isEmpty() ? SolverCatalog.create(name)
                : SolverCatalog.create(name, tolerances.get().relative(), tolerances.get().absolute());
    }
}
