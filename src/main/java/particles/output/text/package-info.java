/** Numbers and tables as text: axis ticks, tables for the screen, for Markdown and as CSV, and a check for fonts. */
package particles.output.text;
