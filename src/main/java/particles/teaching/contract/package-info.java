/**
 * Checks of the rules that hold for every solver, whatever its method: the clock, motions that are exact, what it may
 * remember of earlier steps, sources of any size, steps of any sign, and sources that fail. {@link
 * particles.teaching.contract.Phrase} has the sentences of all findings.
 */
package particles.teaching.contract;
