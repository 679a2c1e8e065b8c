/** The JDK's compiler, for students' classes. */
package particles.javac;
