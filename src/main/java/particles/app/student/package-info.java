/**
 * The commands for students' classes: skeletons, checks and exercises. Code that calls a class runs in a child
 * process. Marks are given in {@code particles.app.course}.
 */
package particles.app.student;
