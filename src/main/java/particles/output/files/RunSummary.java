package particles.output.files;

import java.util.Map;

/**
 * The summary of a run, written to {@code run.json}.
 *
 * @param scene              the scene's name
 * @param sceneHash          SHA-256 of the scene file's bytes, in hexadecimal
 * @param solver             the solver's name
 * @param deltaT             the time step (s)
 * @param duration           the duration in the scene (s)
 * @param endTime            the simulated time reached (s): less than the duration if the run ended early
 * @param version            the program's version
 * @param steps              the number of steps
 * @param evaluations        the number of evaluations of the derivative
 * @param secondsTaken       wall-clock time of the run (s)
 * @param startEnergy        total energy at the start (J)
 * @param endEnergy          total energy at the end (J)
 * @param energyScale        the energy by which errors are divided (J): the largest kinetic plus stored energy of the
 *                           run, or for a scene at rest its weight times its height
 * @param largestEnergyDrift the total energy's largest distance from its start during the run (J)
 * @param work               the work of each kind of physics, by name (J); negative if it took energy out
 * @param numericalError     the change of energy that no work explains, at the end (J)
 * @param largestNumericalError its largest absolute value during the run (J)
 */
public record RunSummary(String scene, String sceneHash, String solver, double deltaT, double duration, double endTime,
                         String version, long steps, long evaluations, double secondsTaken, double startEnergy,
                         double endEnergy, double energyScale, double largestEnergyDrift, Map<String, Double> work,
                         double numericalError, double largestNumericalError) {

    /** @return (end - start) / scale; 0 if nothing changed */
    public double relativeDrift() {
        return relative(endEnergy - startEnergy);
    }

    /** @return the largest |E(t) - E(0)| / scale of the run; 0 where nothing changed */
    public double largestRelativeDrift() {
        return relative(largestEnergyDrift);
    }

    /** @return the largest numerical error / scale of the run; 0 where there was none */
    public double largestRelativeNumericalError() {
        return relative(largestNumericalError);
    }

    /** @return the numerical error at the end / scale; 0 where there is none */
    public double relativeNumericalError() {
        return relative(numericalError);
    }

    private double relative(double drift) {
        return drift == 0 ? 0 : drift / energyScale;
    }
}
