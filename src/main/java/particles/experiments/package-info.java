/**
 * What is measured of runs: observers that record, and experiments that run, both returning plain records and chart
 * data that {@code particles.output} can draw and a test can look at.
 *
 * <p>{@link particles.experiments.energy.EnergyHistory} and {@link particles.experiments.phase.PhaseHistory} are added
 * to a simulation as observers and asked for their charts after the run;
 * {@link particles.experiments.phase.VectorFields} computes the arrows behind the phase plot of a system with one
 * degree of freedom:
 * <pre>
 *     EnergyHistory energy = new EnergyHistory();
 *     PhaseHistory phase = new PhaseHistory("bob");
 *     simulation.addObserver(energy);
 *     simulation.addObserver(phase);
 *     simulation.run();
 *     List&lt;ChartData&gt; energies = energy.charts("One spring, rk4");
 *     ChartData path = phase.chart(phase.widestAxis(), "One spring, rk4");
 * </pre>
 */
package particles.experiments;
