/**
 * Evaluates large systems on several threads, with the same bits as on one; see {@link
 * particles.threads.ParallelForces}.
 */
package particles.threads;
