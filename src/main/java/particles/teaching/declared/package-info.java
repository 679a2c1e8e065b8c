/**
 * The first step of the check of a solver: what it is declared to be. A {@link particles.teaching.declared.Method} has
 * its steps, as the weights of a {@link particles.teaching.declared.Scheme} or an
 * {@link particles.teaching.declared.Equation} of the new state.
 */
package particles.teaching.declared;
