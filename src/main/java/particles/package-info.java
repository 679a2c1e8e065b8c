/**
 * Particle and mass-spring systems: the data, the source that solvers step, the parts that a scene composes, and the
 * simulation loop.
 *
 * <p>"A set of particles, plus a set of rules governing their motion": {@link particles.ParticleSystem} holds the
 * particles' state (x<sub>1</sub>, v<sub>1</sub>, x<sub>2</sub>, v<sub>2</sub>, ...) in R<sup>6n</sup> and lets what
 * the scene names act on it -
 * <ul>
 * <li>{@link particles.law.Effect}: a force that depends on state and time - gravity, springs, drag;</li>
 * <li>{@link particles.law.Reaction}: a force that answers the total of the others - contact, friction, rods;</li>
 * <li>{@link particles.Rule}: a jump between two steps - a bounce, a birth, a tear;</li>
 * <li>{@link particles.Observer}: reads and never changes anything - frames, plots, ledgers.</li>
 * </ul>
 * What is not named is not built and costs nothing. All lengths are in metres, masses in kilograms, times in seconds;
 * y points up.
 */
package particles;
