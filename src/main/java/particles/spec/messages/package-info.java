/** Places in files, and the wording of messages about them. */
package particles.spec.messages;
