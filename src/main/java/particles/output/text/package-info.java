/**
 * Numbers and tables as text: axis ticks, tables for the screen, for Markdown and as CSV, and whether fonts are there.
 */
package particles.output.text;
