package particles.teaching.solvers;

import java.util.Optional;
import particles.teaching.Finding;

/** A search for a mistake. */
interface Search {
    /** @return the mistake, if it is there */
    Optional<Finding> find();

    /** @return what is found first; a search whose steps the solver refuses finds nothing */
    static Optional<Finding> first(Search... searches) {
        for (Search search : searches) {
            try {
                Optional<Finding> found = search.find();
                if (found.isPresent()) {
                    return found;
                }
            } catch (RuntimeException e) {
                continue;                               // it wants another source, or shorter steps
            }
        }
        return Optional.empty();
    }
}
