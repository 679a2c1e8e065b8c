package particles.teaching.declared;

import deSolvers.DESolver;
import deSolvers.DEStateSource;

/** How a step is made: the work of {@link DESolver#stepState}. */
public interface Step {
    /**
     * Makes a step.
     *
     * @param source the source
     * @param deltaT the length (s)
     */
    void make(DEStateSource source, double deltaT);

    /** @return a solver that makes such steps */
    default DESolver solver() {
        return new DESolver() {
            @Override
            public void stepState(DEStateSource source, double deltaT) {
                make(source, deltaT);
            }
        };
    }
}
