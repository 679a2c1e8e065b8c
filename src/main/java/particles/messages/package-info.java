/** What people are told of a run that cannot go on, and the numbers in it. */
package particles.messages;
