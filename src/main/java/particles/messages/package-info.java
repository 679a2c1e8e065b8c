/** Messages about a run that cannot go on, and the format of numbers in messages. */
package particles.messages;
