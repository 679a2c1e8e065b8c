/**
 * Particle and mass-spring systems: {@link particles.ParticleSystem}, the source that solvers step, and {@link
 * particles.Simulation}, the loop around it.
 *
 * <p>"A set of particles, plus a set of rules governing their motion": the particles' state is (x<sub>1</sub>,
 * v<sub>1</sub>, x<sub>2</sub>, v<sub>2</sub>, ...) in R<sup>6n</sup>. {@link particles.Simulation} makes a step in
 * this order:
 *
 * <ol>
 * <li>It tells each {@link particles.Rule} that a step begins.</li>
 * <li>{@link particles.EventSteps} makes the step:
 *     <ul>
 *     <li>the solver's {@link deSolvers.DESolver#stepState} asks for the derivative as often as its method needs;</li>
 *     <li>each time, {@link particles.ParticleSystem#getStateDerivative} has {@link particles.engine.ForceSum} add up
 *         the forces of every {@link particles.law.Effect} (gravity, springs, drag), and then of every
 *         {@link particles.law.Reaction}, which depend on that sum (contact, friction, rods; where a particle has
 *         both a rod and a contact, both are solved together);</li>
 *     <li>if an {@link particles.EventRule} sees an impact in the step, {@link particles.EventLocator} finds its exact
 *         time. The step is repeated up to there, the impact acts, and the rest of the step follows;</li>
 *     <li>if the solver fails in contact, the step is made in two halves, each in this order.</li>
 *     </ul></li>
 * <li>Each {@link particles.Observer} whose time has come sees the motion: frames, plots, the {@code
 *     particles.energy.EnergyLedger}.</li>
 * <li>Each {@link particles.Rule} may change the state, and add or remove particles and springs. Observers are told of
 *     each change. After a change the solver is {@linkplain deSolvers.DESolver#reset reset}.</li>
 * <li>The last rule, {@link particles.EnergyLimit}, ends a run whose kinetic energy has blown up. ({@code
 *     particles.energy.NumericalErrorLimit}, an observer, ends a run whose energy is almost all numerical error.)</li>
 * </ol>
 *
 * <p>The program creates only the effects and rules that the scene names. Lengths are in metres, masses in kilograms,
 * times in seconds; y points up.
 */
package particles;
