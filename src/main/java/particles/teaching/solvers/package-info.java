/**
 * The check of a student's solver, in three steps that are a package each: what it is meant to be is {@linkplain
 * particles.teaching.declared declared}, its steps are {@linkplain particles.teaching.compared compared} with known
 * ones, and what cannot be compared is {@linkplain particles.teaching.measured measured}.
 */
package particles.teaching.solvers;
