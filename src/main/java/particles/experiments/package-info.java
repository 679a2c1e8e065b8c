/**
 * What is measured of runs: observers that record, and experiments that run, both returning plain records and chart
 * data that {@code particles.output} can draw and a test can look at.
 *
 * <p>{@link particles.experiments.EnergyHistory} and {@link particles.experiments.PhaseHistory} are added to a
 * simulation as observers and asked for their charts after the run; {@link particles.experiments.VectorFields}
 * computes the arrows behind the phase plot of a system with one degree of freedom:
 * <pre>
 *     EnergyHistory energy = new EnergyHistory();
 *     PhaseHistory phase = new PhaseHistory("bob");
 *     simulation.addObserver(energy);
 *     simulation.addObserver(phase);
 *     simulation.run();
 *     List&lt;ChartData&gt; energies = energy.charts("One spring, rk4");
 *     ChartData path = phase.chart(phase.widestAxis(), "One spring, rk4");
 * </pre>
 *
 * <h2>The experiments and their options</h2>
 * Each is a task that writes pictures, the numbers behind them and what they say to {@code build/out}. All but the
 * report are done within a minute, and {@code -Psolvers=rk4,verlet} selects solvers.
 * <ul>
 * <li>{@code gradle effectCost}: what each effect and rule adds to the time of a step, on a cloth; {@code
 *     -Pcolumns=64} for a larger one</li>
 * <li>{@code gradle energyDrift}: which solvers keep the energy of a scene, apart from what physics takes; {@code
 *     -Pscene=3} for another scene</li>
 * <li>{@code gradle lectureFigures}: the slides' figures of Euler, midpoint and RK4, amplitude and phase beside
 *     theory; {@code -Psolver=verlet -PdeltaT=0.5 -Psteps=200} adds one</li>
 * <li>{@code gradle phasePlots}: the path of a particle in state space, each solver over the reference; {@code
 *     '-Pparticles=p;q' -Paxes=xy} for other particles and axes</li>
 * <li>{@code gradle race}: solvers beside each other with equal work, in one animation, each over the ghost of a
 *     reference; with implicit ones, equal time</li>
 * <li>{@code gradle stability}: how long a step may be, as limits and regions of every solver measured beside
 *     theory; {@code -Pscene=5} finds the largest safe deltaT of a scene, from its spectrum and by running it</li>
 * <li>{@code gradle stiffGallery}: one spring's stiffness over eight decades, and what each solver pays to stay
 *     stable, to be right within 1 %, and in damping</li>
 * <li>{@code gradle workPrecision}: error against evaluations and against time on six problems, from the oscillator
 *     to a stiff chain, with fitted orders</li>
 * <li>{@code gradle report}: all of these on one page for the browser or for print, {@code report.html}, in about a
 *     minute; {@code -Pscene=3} looks at a scene</li>
 * </ul>
 */
package particles.experiments;
