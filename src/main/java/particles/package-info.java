/**
 * Particle and mass-spring systems: {@link particles.ParticleSystem}, the source that solvers step, and {@link
 * particles.Simulation}, the loop around it.
 *
 * <p>"A set of particles, plus a set of rules governing their motion": the particles' state is (x<sub>1</sub>,
 * v<sub>1</sub>, x<sub>2</sub>, v<sub>2</sub>, ...) in R<sup>6n</sup>. What a step does, in the order in which the
 * classes are called:
 *
 * <ol>
 * <li>{@link particles.Simulation} tells each {@link particles.Rule} that a step begins;</li>
 * <li>it lets {@link particles.EventSteps} make a step, or several shorter ones if there are
 * events in it;</li>
 * <li>the solver's {@link deSolvers.DESolver#stepState} asks for the derivative as often as its method needs;</li>
 * <li>{@link particles.ParticleSystem#getStateDerivative} hands the state to the engine;</li>
 * <li>{@link particles.engine.ForceSum} adds up each {@link particles.law.Effect}: gravity, springs, drag;</li>
 * <li>each {@link particles.law.Reaction} adds the forces that depend on this sum: contact, friction, rods;</li>
 * <li>{@link particles.EventLocator} finds the impacts that an {@link particles.EventRule} saw in the step;</li>
 * <li>{@link particles.Observers} shows the motion to each {@link particles.Observer}: frames, plots, the
 * {@link particles.EnergyLedger};</li>
 * <li>each {@link particles.Rule} may change the state, adding or removing particles and springs too, and observers
 * are told of each change; if one did, the solver is {@linkplain deSolvers.DESolver#reset reset};</li>
 * <li>{@link particles.EnergyLimit} ends a run that has blown up.</li>
 * </ol>
 *
 * <p>Only effects and rules that the scene names are created and cost time. Lengths are in metres, masses in kilograms,
 * times in seconds; y points up.
 */
package particles;
