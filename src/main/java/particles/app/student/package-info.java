/**
 * The commands for students' classes: skeletons, checks, exercises and marks. What calls a student's class runs in a
 * process of its own.
 */
package particles.app.student;
