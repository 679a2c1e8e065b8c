/**
 * Large systems on several threads, with the same bits as on one. A system knows nothing of them:
 * {@link particles.threads.ParallelForces} is handed to it from outside.
 */
package particles.threads;
