/**
 * Where something was found in a file, and how a message says what is wrong there.
 */
package particles.spec.messages;
