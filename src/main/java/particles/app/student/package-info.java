/**
 * The commands for students' classes: skeletons, checks and exercises. {@code Javac} compiles these classes, {@code
 * PageClasses} those of the page in the browser. Code that calls a class runs in a child process. Marks are given in
 * {@code particles.app.course}.
 */
package particles.app.student;
