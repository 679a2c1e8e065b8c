/** Messages about a run that cannot go on: what happened, why, and the one rule of what to try. */
package particles.messages;
