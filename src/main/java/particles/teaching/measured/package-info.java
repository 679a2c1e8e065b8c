/**
 * The third step: what cannot be compared is measured, such as the clock, motions that every method makes exactly, the
 * order on three sources, stability, step-size control, what is kept of earlier steps, and what every solver has to do
 * with any source. {@link particles.teaching.measured.Phrase} lists all findings.
 */
package particles.teaching.measured;
