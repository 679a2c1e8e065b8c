/**
 * Test problems that a student's solver steps in a check: springs, nonlinear laws, and probes that record every call.
 */
package particles.teaching.sources;
