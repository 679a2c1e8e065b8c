/**
 * Interfaces for force laws, and the data they use: {@link particles.law.Effect} and {@link
 * particles.law.ParticleForce} for forces that depend on state and time, {@link particles.law.Reaction} for forces that
 * depend on the sum of the others, and {@link particles.law.Particles}, {@link particles.law.Vector3}, planes,
 * spheres and the motions of anchors.
 *
 * <p>To write a force law, read {@link particles.law.ParticleForce} or {@link particles.law.Effect}; nothing else is
 * needed. The optional interfaces ({@link particles.law.PerParticleEffect}, {@link particles.law.ConstantForce},
 * {@link particles.law.DivisibleEffect}, {@link particles.law.DifferentiableEffect}) make a law faster or give implicit
 * solvers exact derivatives; with {@link particles.law.BriefForce}, adaptive solvers do not step across a law that acts
 * for a short time only. A law without them works too.
 */
package particles.law;
