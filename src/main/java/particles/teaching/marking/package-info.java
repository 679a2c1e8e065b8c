/** The marking of exercises: numbers derived from a student's id, and marks for the answers that the student typed. */
package particles.teaching.marking;
