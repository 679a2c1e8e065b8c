/** How an exercise gets its numbers from a student's id, and its mark from the answer that the student typed. */
package particles.teaching.marking;
