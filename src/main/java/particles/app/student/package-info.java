/**
 * The commands for students' classes: skeletons, checks, exercises and marks. Code that calls a student's class runs in
 * a child process.
 */
package particles.app.student;
